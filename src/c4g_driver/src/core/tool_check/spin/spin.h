// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "tool_check/spin/spin_arm.h"

namespace c4g_driver {

/// A turn of the tool at each node, and the robot's joints there.
struct Spin {
  std::vector<double> turns;   // [rad]
  std::vector<Joints> joints;  // [rad]
};

/// The turns of least cost in one posture, from a grid of up to three quarters of a turn either
/// way, by dynamic programming from node to node.
/// @param start [rad] at the first node, at a turn of 0
/// @param begins_there whether the turn at the first node must be 0
/// @return none if no turns are possible
std::optional<Spin> search_spin(const SpinArm& arm, const std::vector<SpinNode>& nodes,
                                const Joints& start, bool begins_there);

/// Refines the turns off the grid to lower the cost, by damped Newton steps (Levenberg 1944) while
/// it decreases.
void refine_spin(const SpinArm& arm, const std::vector<SpinNode>& nodes, bool begins_there,
                 Spin& spin);

/// The path's tips with the turns, interpolated evenly in time between nodes.
std::vector<Eigen::Isometry3d> spun_tips(const SpinPath& path, const std::vector<SpinNode>& nodes,
                                         const std::vector<double>& turns);

}  // namespace c4g_driver
