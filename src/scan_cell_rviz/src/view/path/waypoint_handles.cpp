// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/path/waypoint_handles.h"

#include <ros/this_node.h>

#include <QTimer>

#include "path/handle_edits.h"
#include "scan_cell_common/ros/conversions.h"
#include "view/handle_controls.h"

namespace scan_cell_rviz {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerFeedback;

WaypointHandles::WaypointHandles(PathSession& session)
    : session_(session), server_(ros::this_node::getName() + "/waypoint") {
  connect(&session_, &PathSession::changed, this, &WaypointHandles::draw);
  connect(&session_, &PathSession::selectionChanged, this, &WaypointHandles::draw);
}

void WaypointHandles::show() {
  shown_ = true;
  draw();
}

void WaypointHandles::draw() {
  if (!shown_) return;
  server_.clear();
  if (const auto& chosen = session_.selected()) {
    constexpr float kAcross = 0.06F;  // [m] chosen
    InteractiveMarker marker;
    marker.header.frame_id = session_.frame();
    marker.name = "waypoint";
    marker.pose = scan_cell_common::to_ros_pose(session_.waypoints()[chosen->last].pose);
    marker.scale = kAcross;
    add_arrows_and_rings(marker);
    server_.insert(marker, [this](const Feedback& feedback) { on_feedback(feedback); });
  }
  server_.apply();
}

void WaypointHandles::on_feedback(const Feedback& feedback) {
  if (feedback->event_type != InteractiveMarkerFeedback::MOUSE_UP) return;
  // Later: the edit redraws the marker, and this is a callback of it.
  QTimer::singleShot(0, this, [this, feedback] { take(feedback); });
}

void WaypointHandles::take(const Feedback& feedback) {
  if (!session_.selected()) return;
  const Eigen::Isometry3d before = session_.waypoints()[session_.selected()->last].pose;
  const auto edits = edits_between(before, scan_cell_common::from_ros(feedback->pose),
                                   session_.edited().path.has_orientation, *session_.selected());
  if (!edits.empty()) session_.add(edits);
}

}  // namespace scan_cell_rviz
