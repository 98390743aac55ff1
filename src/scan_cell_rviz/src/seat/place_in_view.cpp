// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "seat/place_in_view.h"

#include <Eigen/Geometry>

namespace scan_cell_rviz {
namespace {

constexpr double kAround = 1.9;  // of a path or poses, to show what is around; chosen

std::optional<PlaceInView> place_of(const Eigen::AlignedBox3d& box, double around,
                                    const std::string& frame) {
  if (box.isEmpty()) return std::nullopt;
  return PlaceInView{box.center(), around * box.diagonal().norm() / 2,
                     QString::fromStdString(frame)};
}

}  // namespace

std::optional<PlaceInView> place_of(const PathSession& session) {
  Eigen::AlignedBox3d box;
  for (const tool_paths::Waypoint& waypoint : session.waypoints())
    box.extend(waypoint.pose.translation());
  return place_of(box, kAround, session.frame());
}

std::optional<PlaceInView> place_of(const EditSession& session) {
  const EditedViewPtr view = session.view();
  if (!view) return std::nullopt;
  Eigen::AlignedBox3d box;
  for (const std::uint32_t i : view->shown)
    box.extend((*view->source)[i].getVector3fMap().cast<double>());
  return place_of(box, 1, view->frame);
}

std::optional<PlaceInView> place_of(const PickSession& session) {
  return place_of(session.box(), 1, session.frame());
}

std::optional<PlaceInView> place_of(const PassSession& session) {
  Eigen::AlignedBox3d box;
  for (const scan_cell_msgs::ScanPass& pass : session.passes())
    for (const geometry_msgs::Pose& pose : pass.poses)
      box.extend(Eigen::Vector3d(pose.position.x, pose.position.y, pose.position.z));
  return place_of(box, kAround, session.frame());
}

}  // namespace scan_cell_rviz
