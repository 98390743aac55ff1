// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The preview of the work in an rviz view: the joints determine the ghost's place.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include "fixtures/rviz_view.h"
#include "view/preview/preview_display.h"

namespace scan_cell_rviz {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

/// Poses of a Smart5 SiX: leant forward; also J1 turned by 90 degrees, to the right; out of reach.
/// @param speed [m/s] distinguishes previews
scan_cell_msgs::WorkPreview two_poses(double speed) {
  scan_cell_msgs::WorkPreview preview;
  preview.header.frame_id = "base_link";
  preview.path_waypoints = {0, 1, 2};
  preview.waypoints.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    preview.waypoints[i].tip.orientation.w = 1;
    preview.waypoints[i].speed = speed;
  }
  for (int i = 1; i <= 6; ++i)
    preview.joint_names.push_back("joint_" + std::to_string(i));
  preview.joints.assign(18, 0);
  preview.joints[1] = preview.joints[7] = 0.5;
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

  /// @param mark text that only its status has
  void show(const scan_cell_msgs::WorkPreview& preview, const QString& mark) {
    display_->subProp("Pose")->setValue(0);
    shown_.publish(preview);
    EXPECT_TRUE(comes([&] { return status_of(*display_, "Way").contains(mark); }))
        << status_of(*display_, "Way").toStdString();
  }

  static bool ghost_says(const QString& words) {
    return comes([&] { return status_of(*display_, "Ghost").contains(words); });
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
  show(two_poses(0.11), "110 mm/s");
  ASSERT_TRUE(comes([] { return display_->ghost("flange").has_value(); }));
  const Vector3d base(0, 0, 0.5);  // in the world
  const Vector3d straight = *display_->ghost("flange") - base;
  EXPECT_GT(straight.head<2>().norm(), 0.1);
  display_->subProp("Pose")->setValue(1);
  ASSERT_TRUE(display_->ghost("flange").has_value());
  const Vector3d turned = AngleAxisd(-M_PI / 2, Vector3d::UnitZ()) * straight + base;
  EXPECT_LT((*display_->ghost("flange") - turned).norm(), 1e-5);
  EXPECT_TRUE(ghost_says("90.0"));
  EXPECT_TRUE(display_->ghost("bracket").has_value()) << "what is on the flange goes with it";
}

TEST_F(Preview, HidesTheGhostWhereTheRobotDoesNotGet) {
  show(two_poses(0.12), "120 mm/s");
  ASSERT_TRUE(comes([] { return display_->ghost("flange").has_value(); }));
  display_->subProp("Pose")->setValue(2);
  EXPECT_FALSE(display_->ghost("flange").has_value());
  EXPECT_TRUE(ghost_says("does not get there"));
}

TEST_F(Preview, SaysWhyTheRobotCannotFollow) {
  scan_cell_msgs::WorkPreview preview = two_poses(0.13);
  preview.faults.resize(1);
  preview.faults.front().tip.orientation.w = 1;
  preview.faults.front().message = preview.message = "waypoint 2: out of reach by 0.1 m";
  show(preview, QString::fromStdString(preview.message));
}

TEST_F(Preview, ShowsNoGhostOfAnotherRobot) {
  scan_cell_msgs::WorkPreview preview = two_poses(0.14);
  preview.joint_names[0] = "a_joint_of_another";
  show(preview, "140 mm/s");
  EXPECT_TRUE(ghost_says("a_joint_of_another"));
  EXPECT_FALSE(display_->ghost("flange").has_value());
}

TEST_F(Preview, HidesAllWhereItsFrameIsNotKnown) {
  scan_cell_msgs::WorkPreview preview = two_poses(0.15);
  show(preview, "150 mm/s");
  ASSERT_TRUE(comes([] { return display_->ghost("flange").has_value(); }));
  preview = two_poses(0.16);
  preview.header.frame_id = "nowhere";
  show(preview, "160 mm/s");
  EXPECT_TRUE(comes([] { return status_of(*display_, "Frame").contains("nowhere"); }));
  EXPECT_FALSE(display_->ghost("flange").has_value());
  show({}, "0 poses");
  show(two_poses(0.17), "170 mm/s");
  EXPECT_TRUE(comes([] { return display_->ghost("flange").has_value(); }));
  EXPECT_TRUE(comes([] { return status_of(*display_, "Frame").isEmpty(); }));
}

TEST_F(Preview, OutlivesNamesThatAreNoneAndForgetsWhatCameByAnother) {
  show(two_poses(0.18), "180 mm/s");
  display_->subProp("Topic")->setValue("no name ~");
  EXPECT_TRUE(comes([] { return !status_of(*display_, "Topic").isEmpty(); }));
  EXPECT_FALSE(display_->ghost("flange").has_value());
  display_->subProp("Topic")->setValue("/scan_cell/work_preview");
  EXPECT_TRUE(comes([] { return display_->ghost("flange").has_value(); })) << "it is latched";
  display_->subProp("Robot Description")->setValue("~ no name");
  EXPECT_FALSE(display_->ghost("flange").has_value());
  EXPECT_TRUE(ghost_says("not a URDF"));
  display_->subProp("Robot Description")->setValue("robot_description");
  EXPECT_TRUE(display_->ghost("flange").has_value());
}

TEST_F(Preview, DrawsThatOfTheRunInViewAlone) {
  scan_cell_msgs::WorkPreview preview = two_poses(0.21);
  preview.path = "/runs/run_1/adapted_path.csv";
  show(preview, "210 mm/s");
  ASSERT_TRUE(comes([] { return display_->ghost("flange").has_value(); }));
  display_->subProp("Run")->setValue("run_2");
  EXPECT_FALSE(display_->ghost("flange").has_value()) << "it is of another run";
  EXPECT_TRUE(comes([] {
    return status_of(*display_, "Way") ==
           "one came of /runs/run_1/adapted_path.csv, not of this run";
  })) << status_of(*display_, "Way").toStdString();
  display_->subProp("Run")->setValue("run_1");
  EXPECT_TRUE(comes([] { return display_->ghost("flange").has_value(); })) << "it is latched";
  scan_cell_msgs::WorkPreview other = two_poses(0.22);
  other.path = "/runs/run_3/adapted_path.csv";
  shown_.publish(other);
  preview.waypoints[0].speed = preview.waypoints[1].speed = preview.waypoints[2].speed = 0.23;
  show(preview, "230 mm/s");
  display_->subProp("Run")->setValue("");
  EXPECT_TRUE(comes([] { return display_->ghost("flange").has_value(); })) << "any will do";
}

TEST_F(Preview, DrawsNothingWhileItIsHidden) {
  show(two_poses(0.19), "190 mm/s");
  display_->setEnabled(false);
  display_->reset();
  EXPECT_FALSE(display_->ghost("flange").has_value());
  display_->setEnabled(true);
  EXPECT_TRUE(comes([] { return display_->ghost("flange").has_value(); }));
}

}  // namespace
}  // namespace scan_cell_rviz
