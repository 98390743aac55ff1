// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "tool_check/spin/spin_arm.h"

namespace c4g_driver {

/// A turn of the tool at each node, and the robot there.
struct Spin {
  std::vector<double> turns;   // [rad]
  std::vector<Joints> joints;  // [rad]
};

/// The turns of least cost in one posture, of a grid of turns up to three quarters of a turn either
/// way: dynamic programming from node to node.
/// @param start [rad] at the first node, at a turn of 0
/// @param begins_there the turn at the first node is 0
/// @return none if no turns are possible
std::optional<Spin> search_spin(const SpinArm& arm, const std::vector<SpinNode>& nodes,
                                const Joints& start, bool begins_there);

/// The same turns off the grid at less cost: damped Newton steps (Levenberg 1944) while the cost
/// falls.
void refine_spin(const SpinArm& arm, const std::vector<SpinNode>& nodes, bool begins_there,
                 Spin& spin);

/// The path's tips with the turns, evenly between nodes.
std::vector<Eigen::Isometry3d> spun_tips(const SpinPath& path, const std::vector<SpinNode>& nodes,
                                         const std::vector<double>& turns);

}  // namespace c4g_driver
