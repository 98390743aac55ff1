// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tool_check/judge/judge.h"

namespace c4g_driver {

/// A waypoint at which the turn about the tool's axis is chosen; in between it changes evenly.
struct SpinNode {
  std::size_t waypoint;
  Eigen::Isometry3d tip;  // at a turn of 0, in base_link
  double seconds;         // since the node before
};

/// A path whose tool may turn about its z. A turn of 0 is that of the first waypoint, carried along
/// with the least rotation.
struct SpinPath {
  std::vector<Eigen::Isometry3d> tips;  // of each waypoint at a turn of 0, in base_link
  std::vector<double> seconds;          // since the start of the path
};

/// @param begin [rad] turn of the first waypoint's own pose that counts as 0
SpinPath spin_path(const ToolCheckSubject& subject, double begin);

/// The first waypoint, the last one, and those in between that are at least this far from the node
/// before.
/// @param length [m] of the tip's way
/// @param angle [rad] of the tool's axis
std::vector<SpinNode> spin_nodes(const SpinPath& path, double length, double angle);

/// The tip's pose turned about its z [rad].
Eigen::Isometry3d spun(const Eigen::Isometry3d& tip, double turn);

}  // namespace c4g_driver
