// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Passes of a scan as markers, and dragged by their handles.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <visualization_msgs/InteractiveMarkerFeedback.h>
#include <visualization_msgs/InteractiveMarkerInit.h>

#include <functional>

#include "fixtures/rviz_view.h"
#include "view/passes/pass_handles.h"

namespace scan_cell_rviz {
namespace {

using scan_cell_msgs::ScanPass;
using visualization_msgs::InteractiveMarkerFeedback;
using visualization_msgs::MarkerArray;

bool comes_with_ros(const std::function<bool()>& condition) {
  return comes([&] {
    ros::spinOnce();
    return condition();
  });
}

/// A line, and three quarters of a circle about the origin, 100 mm wide.
PassSession::Passes made_passes() {
  PassSession::Passes passes(2);
  passes[0].kind = ScanPass::LINE;
  passes[0].poses.resize(2);
  passes[0].poses[1].position.x = 0.3;
  passes[1].kind = ScanPass::ARC;
  passes[1].poses.resize(3);
  passes[1].poses[0].position.x = 0.1;
  passes[1].poses[1].position.x = -0.1;
  passes[1].poses[2].position.y = -0.1;
  for (auto& pass : passes)
    for (auto& pose : pass.poses)
      pose.orientation.w = 1;
  passes[1].poses[1].position.y = 1e-9;  // over +y, not -y
  return passes;
}

TEST(PassMarkers, FollowAnArcOverItsViaPoint) {
  PassSession session;
  session.open("world", made_passes());
  const MarkerArray all = pass_markers(session);
  ASSERT_EQ(all.markers.size(), 1u + 2 * 3);
  const auto& arc = all.markers[4].points;
  double least_y = 0, most_y = 0;
  for (const auto& point : arc) {
    EXPECT_NEAR(std::hypot(point.x, point.y), 0.1, 1e-6);
    least_y = std::min(least_y, point.y);
    most_y = std::max(most_y, point.y);
  }
  EXPECT_NEAR(most_y, 0.1, 1e-3);
  EXPECT_NEAR(least_y, -0.1, 1e-3);
  EXPECT_NEAR(arc.back().y, -0.1, 1e-9);
}

TEST(PassMarkers, TellWhatIsOutOfReachByWidthAndWordsToo) {
  PassSession session;
  session.open("world", made_passes());
  session.show_reach({{Reach::kNot, "the arm is too short"}, {Reach::kReachable, ""}});
  const MarkerArray all = pass_markers(session);
  EXPECT_GT(all.markers[1].scale.x, 2 * all.markers[4].scale.x);
  EXPECT_EQ(all.markers[3].text, "1\nthe arm is too short");
  EXPECT_EQ(all.markers[6].text, "2");
}

TEST(PassHandles, MoveThePoseThatWasDraggedOnceItIsLetGo) {
  PassSession session;
  session.open("world", made_passes());
  PassHandles handles(session);
  handles.show(true);
  session.select(PassPose{1, 0});
  ros::NodeHandle node;
  visualization_msgs::InteractiveMarkerInitConstPtr shown;
  const ros::Subscriber subscriber = node.subscribe<visualization_msgs::InteractiveMarkerInit>(
      handles.handles() + "/update_full", 1, [&](const auto& init) { shown = init; });
  const ros::Publisher feedback =
      node.advertise<InteractiveMarkerFeedback>(handles.handles() + "/feedback", 10);
  ASSERT_TRUE(comes_with_ros([&] {
    return shown && shown->markers.size() == 3 && feedback.getNumSubscribers() > 0;
  })) << "start, via and end";
  InteractiveMarkerFeedback told;
  told.client_id = "a person";
  told.marker_name = "pose_1";
  told.pose.position.y = 0.2;
  told.pose.orientation.w = 1;
  told.event_type = InteractiveMarkerFeedback::POSE_UPDATE;
  feedback.publish(told);
  told.event_type = InteractiveMarkerFeedback::MOUSE_UP;
  feedback.publish(told);
  ASSERT_TRUE(comes_with_ros([&] { return session.can_undo(); }));
  EXPECT_EQ(session.passes()[1].poses[1].position.y, 0.2);
  EXPECT_EQ(session.passes()[1].poses[0].position.x, 0.1);
  session.undo();
  EXPECT_FALSE(session.can_undo()) << "one drag is one change";
}

}  // namespace
}  // namespace scan_cell_rviz
