// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/scan/box_handles.h"

#include <ros/this_node.h>

#include <algorithm>

#include "edit/box.h"
#include "scan_cell_common/ros/conversions.h"
#include "view/handle_controls.h"

namespace scan_cell_rviz {
namespace {

using cloud_preprocess::BoxShape;
using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::InteractiveMarkerFeedback;
using visualization_msgs::Marker;

constexpr const char* kBox = "box";

Marker marker_of(std::int32_t type, const Eigen::Vector3d& size, float alpha) {
  Marker marker;
  marker.type = type;
  marker.pose.orientation.w = 1;
  marker.scale.x = size.x();
  marker.scale.y = size.y();
  marker.scale.z = size.z();
  marker.color.r = 0.1F;
  marker.color.g = 0.4F;
  marker.color.b = 0.9F;
  marker.color.a = alpha;
  return marker;
}

/// The handle that moves and turns the box by arrows and rings.
InteractiveMarker body_of(const BoxShape& box) {
  constexpr float kClear = 0.25F;
  InteractiveMarker body;
  body.name = kBox;
  body.description = "";
  body.pose = scan_cell_common::to_ros_pose(box.pose);
  body.scale = static_cast<float>(1.3 * box.size.maxCoeff());
  InteractiveMarkerControl seen;
  seen.always_visible = 1;
  seen.interaction_mode = InteractiveMarkerControl::NONE;
  seen.markers = {marker_of(Marker::CUBE, box.size, kClear)};
  body.controls.push_back(seen);
  add_arrows_and_rings(body);
  return body;
}

/// A ball on a face, to pull it out or push it in.
InteractiveMarker handle_of(const BoxShape& box, int face) {
  constexpr double kShare = 0.08;  // of the longest side; chosen
  InteractiveMarker handle;
  handle.name = "face_" + std::to_string(face);
  Eigen::Isometry3d pose = box.pose;
  pose.translation() = face_middle(box, face);
  handle.pose = scan_cell_common::to_ros_pose(pose);
  handle.scale = static_cast<float>(kShare * box.size.maxCoeff());
  InteractiveMarkerControl control =
      control_of(outward(face), InteractiveMarkerControl::MOVE_AXIS, handle.name);
  control.always_visible = 1;
  control.markers = {
      marker_of(Marker::SPHERE, Eigen::Vector3d::Constant(kShare * box.size.maxCoeff()), 1)};
  handle.controls = {control};
  return handle;
}

}  // namespace

BoxHandles::BoxHandles(EditSession& session)
    : session_(session), server_(ros::this_node::getName() + "/box") {
  connect(&session_, &EditSession::changed, this, [this] {
    const EditedViewPtr view = session_.view();
    if (shown() && (!view || view->frame != frame_)) hide();
  });
}

void BoxHandles::show() {
  const EditedViewPtr view = session_.view();
  if (!view || shown()) return;
  frame_ = view->frame;
  box_ = box_within(*view->source, view->shown);
  draw();
}

void BoxHandles::hide() {
  frame_.clear();
  server_.clear();
  server_.apply();
}

void BoxHandles::apply() {
  if (shown()) session_.apply(box_);
}

void BoxHandles::draw() {
  InteractiveMarker body = body_of(box_);
  body.header.frame_id = frame_;
  server_.insert(body, [this](const Feedback& feedback) { on_box(feedback); });
  for (int face = 0; face < kFaces; ++face) {
    InteractiveMarker handle = handle_of(box_, face);
    handle.header.frame_id = frame_;
    server_.insert(handle, [this, face](const Feedback& feedback) { on_face(face, feedback); });
  }
  server_.apply();
}

void BoxHandles::on_box(const Feedback& feedback) {
  if (feedback->event_type != InteractiveMarkerFeedback::POSE_UPDATE) return;
  box_.pose = scan_cell_common::from_ros(feedback->pose);
  draw();
}

void BoxHandles::on_face(int face, const Feedback& feedback) {
  if (feedback->event_type != InteractiveMarkerFeedback::POSE_UPDATE) return;
  drag_face(box_, face, scan_cell_common::from_ros(feedback->pose).translation());
  draw();
}

}  // namespace scan_cell_rviz
