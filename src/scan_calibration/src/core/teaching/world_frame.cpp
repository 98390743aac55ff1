// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "teaching/world_frame.h"

#include <fmt/core.h>

#include <cmath>

#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

using scan_cell_common::UnusableInput;

void check_distance(const char* thing, double distance, double min_distance, const char* cure) {
  if (distance >= min_distance) return;  // not so for NaN
  throw UnusableInput(thing, fmt::format("{:.2f} mm", distance * 1e3),
                      fmt::format("{}, at least {:.2f} mm", cure, min_distance * 1e3));
}

}  // namespace

WorldFrame world_from_points(const Eigen::Vector3d& o, const Eigen::Vector3d& x,
                             const Eigen::Vector3d& xy, const WorldFrameLimits& limits) {
  check_distance("distance from O to X", (x - o).norm(), limits.min_distance,
                 "teach X further from O");
  const Eigen::Vector3d x_axis = (x - o).normalized();
  const Eigen::Vector3d along_y = xy - x;
  const Eigen::Vector3d off_axis = along_y - along_y.dot(x_axis) * x_axis;
  check_distance("distance from XY to the line through O and X", off_axis.norm(),
                 limits.min_distance, "teach XY further from that line");

  const double skew = std::atan2(along_y.dot(x_axis), off_axis.norm());
  if (std::abs(skew) > limits.max_skew) {
    throw UnusableInput("angle O-X-XY", fmt::format("{:.2f} deg", 90 + skew * 180 / M_PI),
                        "teach XY on the parallel to the Y axis through X");
  }
  WorldFrame world{Eigen::Isometry3d::Identity(), skew};
  world.pose.linear().col(0) = x_axis;
  world.pose.linear().col(1) = off_axis.normalized();
  world.pose.linear().col(2) = x_axis.cross(off_axis.normalized());
  world.pose.translation() = o;
  return world;
}

}  // namespace scan_calibration
