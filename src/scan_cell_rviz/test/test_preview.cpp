// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The preview of the work in a view of rviz: the ghost stands where the joints put it.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <QApplication>

#include "rviz_view.h"
#include "view/preview_display.h"

namespace scan_cell_rviz {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

/// Two poses of a Smart5 SiX: all joints at 0, and J1 turned by 90 degrees, which is to the right.
scan_cell_msgs::WorkPreview two_poses() {
  scan_cell_msgs::WorkPreview preview;
  preview.header.frame_id = "base_link";
  preview.path_waypoints = {0, 1, 2};
  preview.waypoints.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    preview.waypoints[i].tip.orientation.w = 1;
    preview.waypoints[i].speed = 0.1;
  }
  for (int i = 1; i <= 6; ++i)
    preview.joint_names.push_back("joint_" + std::to_string(i));
  preview.joints.assign(18, 0);
  preview.joints[6] = M_PI / 2;
  preview.joints[12] = std::nan("");
  return preview;
}

class Preview : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    view_ = new RvizView;
    display_ = dynamic_cast<PreviewDisplay*>(
        view_->manager.createDisplay("scan_cell_rviz/WorkPreview", "preview", true));
    ASSERT_NE(display_, nullptr);
    ASSERT_TRUE(view_->start());
  }
  static void TearDownTestSuite() { delete view_; }

  void show(const scan_cell_msgs::WorkPreview& preview) {
    shown_.publish(preview);
    EXPECT_TRUE(comes([&] {
      return status_of(*display_, "Way").contains(QString::fromStdString(preview.message)) &&
             !status_of(*display_, "Ghost").isEmpty();
    })) << status_of(*display_, "Way").toStdString();
  }

  static RvizView* view_;
  static PreviewDisplay* display_;
  ros::NodeHandle node_;
  ros::Publisher shown_ =
      node_.advertise<scan_cell_msgs::WorkPreview>("/scan_cell/work_preview", 1, true);
};

RvizView* Preview::view_ = nullptr;
PreviewDisplay* Preview::display_ = nullptr;

TEST_F(Preview, PutsTheGhostWhereThePosesJointsPutIt) {
  show(two_poses());
  display_->subProp("Pose")->setValue(0);
  ASSERT_TRUE(comes([] { return display_->ghost("flange").has_value(); }));
  const Isometry3d straight = *display_->ghost("flange");
  display_->subProp("Pose")->setValue(1);
  ASSERT_TRUE(display_->ghost("flange").has_value());
  EXPECT_TRUE(display_->ghost("flange")->isApprox(
      AngleAxisd(-M_PI / 2, Vector3d::UnitZ()) * straight, 1e-9));
  EXPECT_TRUE(comes([] { return status_of(*display_, "Ghost").contains("90.0"); }));
  EXPECT_TRUE(display_->ghost("bracket").has_value()) << "what is on the flange goes with it";
}

TEST_F(Preview, HidesTheGhostWhereTheRobotDoesNotGet) {
  show(two_poses());
  display_->subProp("Pose")->setValue(2);
  EXPECT_FALSE(display_->ghost("flange").has_value());
  EXPECT_TRUE(comes([] { return status_of(*display_, "Ghost").contains("does not get there"); }));
}

TEST_F(Preview, SaysWhyTheRobotCannotFollow) {
  scan_cell_msgs::WorkPreview preview = two_poses();
  preview.faults.resize(1);
  preview.faults.front().tip.orientation.w = 1;
  preview.faults.front().message = preview.message = "waypoint 2: out of reach by 0.1 m";
  show(preview);
  EXPECT_EQ(status_of(*display_, "Way").toStdString(), preview.message);
}

TEST_F(Preview, OutlivesOneThatIsEmptyOrInAFrameThatNobodyKnows) {
  scan_cell_msgs::WorkPreview preview;
  preview.header.frame_id = "nowhere";
  preview.message = "";
  shown_.publish(preview);
  EXPECT_TRUE(comes([] { return status_of(*display_, "Frame").contains("nowhere"); }));
  EXPECT_FALSE(display_->ghost("flange").has_value());
  show(two_poses());
  EXPECT_TRUE(comes([] { return status_of(*display_, "Frame").isEmpty(); }));
}

}  // namespace
}  // namespace scan_cell_rviz

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_preview");
  const ros::NodeHandle node;
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
