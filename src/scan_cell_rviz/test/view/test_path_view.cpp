// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// A path edited in an rviz view, seen from above: clicked and dragged by its handles.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rviz/tool_manager.h>
#include <visualization_msgs/InteractiveMarkerFeedback.h>
#include <visualization_msgs/InteractiveMarkerInit.h>

#include "fixtures/rviz_view.h"
#include "scan_cell_common/ros/conversions.h"
#include "view/path/waypoint_handles.h"

namespace scan_cell_rviz {
namespace {

using Eigen::Vector3d;
using visualization_msgs::InteractiveMarkerFeedback;

constexpr double kScale = 2000;  // [pixels/m]

/// Waypoints along x, 10 mm apart; the tool's z axis points down.
tool_paths::ToolPath made_path() {
  tool_paths::ToolPath path;
  path.has_orientation = true;
  path.segments.resize(1);
  for (int i = 0; i < 5; ++i) {
    tool_paths::Waypoint waypoint;
    waypoint.pose.translation().x() = 0.01 * i;
    waypoint.pose.rotate(Eigen::AngleAxisd(M_PI, Vector3d::UnitX()));
    path.segments[0].waypoints.push_back(waypoint);
  }
  return path;
}

class PathInView : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    view_ = new RvizView;
    view_->manager.getViewManager()->getCurrent()->subProp("Scale")->setValue(kScale);
    display_ = view_->manager.createDisplay("scan_cell_rviz/EditedPath", "path", true);
    ASSERT_TRUE(view_->start());
    QTest::qWait(200);  // the camera follows the view's settings when it is drawn
    tool_ = view_->manager.getToolManager()->addTool("scan_cell_rviz/Waypoint");
  }
  static void TearDownTestSuite() { delete view_; }

  PathInView() { session().open(made_path(), {}, "world"); }

  static PathSession& session() { return shared_path_session(); }
  static void click(const Vector3d& place, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    view_->mouse(tool_, QEvent::MouseButtonPress, place, modifiers);
    view_->mouse(tool_, QEvent::MouseButtonRelease, place, modifiers);
  }

  static RvizView* view_;
  static rviz::Display* display_;
  static rviz::Tool* tool_;
};

RvizView* PathInView::view_ = nullptr;
rviz::Display* PathInView::display_ = nullptr;
rviz::Tool* PathInView::tool_ = nullptr;

TEST_F(PathInView, AClickChoosesAWaypointAndShiftAllUpToAnother) {
  click({0.0302, 0.0003, 0});
  ASSERT_TRUE(session().selected());
  EXPECT_EQ(session().selected()->first, 3u);
  click({0.01, 0, 0}, Qt::ShiftModifier);
  EXPECT_EQ(session().selected()->first, 1u);
  EXPECT_EQ(session().selected()->last, 3u);
  click({0.035, 0.02, 0});
  EXPECT_EQ(session().selected()->first, 1u) << "beside the path nothing is chosen anew";
}

TEST_F(PathInView, TheDisplayTellsHowManyWereEditedAndDeleted) {
  session().add(tool_paths::DeleteEdit{{0, 1}});
  session().add(tool_paths::MoveEdit{{0, 0}, {0, 0, 0.001}});
  EXPECT_TRUE(comes([] {
    return status_of(*display_, "Path") == "3 waypoints, 1 edited, 2 deleted";
  })) << status_of(*display_, "Path").toStdString();
  session().close();
  EXPECT_TRUE(comes([] { return status_of(*display_, "Path") == "none is in view"; }));
}

TEST_F(PathInView, WhatIsDraggedAtTheHandlesIsAnEditOfAllThatIsChosen) {
  WaypointHandles handles(session());
  handles.show();
  session().select(tool_paths::WaypointRange{2, 3});
  ros::NodeHandle node;
  visualization_msgs::InteractiveMarkerInitConstPtr shown;
  const ros::Subscriber subscriber = node.subscribe<visualization_msgs::InteractiveMarkerInit>(
      handles.topic() + "/update_full", 1, [&](const auto& init) { shown = init; });
  const ros::Publisher feedback =
      node.advertise<InteractiveMarkerFeedback>(handles.topic() + "/feedback", 10);
  ASSERT_TRUE(comes([&] {
    ros::spinOnce();
    return shown && shown->markers.size() == 1 && feedback.getNumSubscribers() > 0;
  }));
  EXPECT_EQ(shown->markers[0].pose.position.x, 0.03) << "they stand at the last one";
  EXPECT_EQ(shown->markers[0].controls.size(), 6u);
  Eigen::Isometry3d dragged = session().waypoints()[3].pose;
  dragged.pretranslate(Vector3d(0, 0.002, 0));
  dragged.rotate(Eigen::AngleAxisd(0.1, Vector3d::UnitZ()));
  InteractiveMarkerFeedback told;
  told.client_id = "a person";
  told.marker_name = "waypoint";
  told.pose = scan_cell_common::to_ros_pose(dragged);
  told.event_type = InteractiveMarkerFeedback::POSE_UPDATE;
  feedback.publish(told);
  told.event_type = InteractiveMarkerFeedback::MOUSE_UP;
  feedback.publish(told);
  ASSERT_TRUE(comes([&] {
    ros::spinOnce();
    return session().can_undo();
  }));
  EXPECT_EQ(session().words().size(), 2) << "a move and a turn, once it is let go";
  EXPECT_TRUE(session().waypoints()[3].pose.isApprox(dragged, 1e-9));
  EXPECT_NEAR(session().waypoints()[2].pose.translation().y(), 0.002, 1e-9);
  EXPECT_EQ(session().waypoints()[1].pose.translation().y(), 0);
}

}  // namespace
}  // namespace scan_cell_rviz
