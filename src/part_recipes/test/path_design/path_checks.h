// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tool_paths/tool_path.h"

/// What tests check in a path.
namespace path_checks {

inline Eigen::Vector3d position(const tool_paths::Waypoint& waypoint) {
  return waypoint.pose.translation();
}

inline std::vector<tool_paths::Waypoint> all(const tool_paths::ToolPath& path) {
  std::vector<tool_paths::Waypoint> waypoints;
  for (const auto& segment : path.segments)
    waypoints.insert(waypoints.end(), segment.waypoints.begin(), segment.waypoints.end());
  EXPECT_FALSE(waypoints.empty());
  return waypoints;
}

inline std::vector<Eigen::Vector3d> positions(const tool_paths::ToolPath& path) {
  std::vector<Eigen::Vector3d> result;
  for (const auto& waypoint : all(path))
    result.push_back(position(waypoint));
  return result;
}

/// [rad]
inline double angle(const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
  return std::atan2(one.cross(other).norm(), one.dot(other));
}

/// The thing that an error of a kind is about; empty if there is no error.
template <class Kind>
std::string thing_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Kind& error) {
    return error.thing();
  }
  return "";
}

}  // namespace path_checks
