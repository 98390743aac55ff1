// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/passes/pass_handles.h"

#include <ros/this_node.h>
#include <tf2_eigen/tf2_eigen.h>

#include <QTimer>
#include <cmath>

#include "scan_cell_common/ros/conversions.h"
#include "view/handle_controls.h"

namespace scan_cell_rviz {
namespace {

using Eigen::Vector3d;
using scan_cell_msgs::ScanPass;
using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerFeedback;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

struct Look {
  float red, green, blue;
  double width;  // [m]
};

/// Width and words tell passes apart, not only colour.
Look look_of(Reach reach) {
  if (reach == Reach::kReachable) return {0.0F, 0.35F, 0.8F, 0.002};
  if (reach == Reach::kNot) return {0.85F, 0.1F, 0.1F, 0.006};
  return {0.5F, 0.5F, 0.5F, 0.002};
}

/// The circular arc through three places; straight if they lie on a line.
std::vector<Vector3d> arc_through(const Vector3d& start, const Vector3d& via, const Vector3d& end) {
  constexpr int kSteps = 40;  // chosen
  const Vector3d a = start - end, b = via - end;
  const Vector3d normal = a.cross(b);
  constexpr double kFlat = 1e-9;  // [m^2] of a line; chosen
  if (normal.norm() < kFlat) return {start, via, end};
  const Vector3d centre =
      end + (a.squaredNorm() * b - b.squaredNorm() * a).cross(normal) / (2 * normal.squaredNorm());
  const Vector3d axis = (via - start).cross(end - via).normalized();
  const Vector3d from = start - centre, to = end - centre;
  double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to));
  if (angle <= 0) angle += 2 * M_PI;
  std::vector<Vector3d> points;
  for (int i = 0; i <= kSteps; ++i)
    points.push_back(centre + Eigen::AngleAxisd(angle * i / kSteps, axis) * from);
  return points;
}

std::vector<Vector3d> way_of(const ScanPass& pass) {
  std::vector<Vector3d> places;
  for (const geometry_msgs::Pose& pose : pass.poses)
    tf2::fromMsg(pose.position, places.emplace_back());
  constexpr std::size_t kOfAnArc = 3;
  return pass.kind == ScanPass::ARC && places.size() == kOfAnArc
             ? arc_through(places[0], places[1], places[2])
             : places;
}

Marker marker_of(const PassSession& session, std::size_t pass, const char* name, int type) {
  const Look look = look_of(session.reach()[pass].reach);
  Marker marker;
  marker.header.frame_id = session.frame();
  marker.ns = name;
  marker.id = static_cast<int>(pass);
  marker.type = type;
  marker.pose.orientation.w = 1;
  marker.color.r = look.red;
  marker.color.g = look.green;
  marker.color.b = look.blue;
  marker.color.a = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = look.width;
  return marker;
}

std::string words_of(const PassSession& session, std::size_t pass) {
  const std::string& name = session.passes()[pass].name;
  const std::string shown = name.empty() ? std::to_string(pass + 1) : name;
  const PassReach& reach = session.reach()[pass];
  return reach.reach == Reach::kNot ? shown + "\n" + reach.why.toStdString() : shown;
}

}  // namespace

MarkerArray pass_markers(const PassSession& session) {
  constexpr double kBall = 0.01, kLetters = 0.015;  // [m] chosen
  MarkerArray all;
  all.markers.resize(1);
  all.markers[0].header.frame_id = session.frame();
  all.markers[0].action = Marker::DELETEALL;
  for (std::size_t i = 0; i < session.passes().size(); ++i) {
    Marker line = marker_of(session, i, "passes", Marker::LINE_STRIP);
    for (const Vector3d& place : way_of(session.passes()[i]))
      line.points.push_back(tf2::toMsg(place));
    if (line.points.empty()) continue;
    Marker poses = marker_of(session, i, "poses", Marker::SPHERE_LIST);
    poses.scale.x = poses.scale.y = poses.scale.z = kBall;
    for (const geometry_msgs::Pose& pose : session.passes()[i].poses)
      poses.points.push_back(pose.position);
    Marker words = marker_of(session, i, "words", Marker::TEXT_VIEW_FACING);
    words.scale.z = kLetters;
    words.pose.position = line.points[line.points.size() / 2];
    words.pose.position.z += 2 * kLetters;
    words.text = words_of(session, i);
    all.markers.insert(all.markers.end(), {line, poses, words});
  }
  return all;
}

PassHandles::PassHandles(PassSession& session)
    : session_(session),
      topic_(ros::this_node::getName() + "/passes"),
      passes_(node_.advertise<MarkerArray>(topic_, 1, true)),
      server_(ros::this_node::getName() + "/pass_poses") {
  connect(&session_, &PassSession::changed, this, &PassHandles::draw);
  connect(&session_, &PassSession::reachChanged, this, &PassHandles::draw);
  connect(&session_, &PassSession::changed, this, &PassHandles::draw_handles);
  connect(&session_, &PassSession::selectionChanged, this, &PassHandles::draw_handles);
}

void PassHandles::show(bool shown) {
  shown_ = shown;
  draw();
  draw_handles();
}

void PassHandles::draw() {
  if (shown_) passes_.publish(pass_markers(session_));
}

void PassHandles::draw_handles() {
  constexpr float kAcross = 0.12F;  // [m] chosen
  server_.clear();
  const auto& chosen = session_.selected();
  if (shown_ && chosen) {
    const ScanPass& pass = session_.passes()[chosen->pass];
    for (std::size_t i = 0; i < pass.poses.size(); ++i) {
      InteractiveMarker marker;
      marker.header.frame_id = session_.frame();
      marker.name = "pose_" + std::to_string(i);
      marker.description = pose_name(pass, i).toStdString();
      marker.pose = pass.poses[i];
      marker.scale = kAcross;
      add_arrows_and_rings(marker);
      server_.insert(marker, [this, pass = chosen->pass, i](const Feedback& feedback) {
        on_feedback(pass, i, feedback);
      });
    }
  }
  server_.apply();
}

void PassHandles::on_feedback(std::size_t pass, std::size_t pose, const Feedback& feedback) {
  if (feedback->event_type != InteractiveMarkerFeedback::MOUSE_UP) return;
  // Later: the change redraws the markers, and this is a callback of one.
  QTimer::singleShot(0, this, [this, pass, pose, to = feedback->pose] {
    const auto& passes = session_.passes();
    if (pass >= passes.size() || pose >= passes[pass].poses.size()) return;
    session_.move({pass, pose}, scan_cell_common::from_ros(to));
  });
}

}  // namespace scan_cell_rviz
