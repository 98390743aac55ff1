// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mapping/graph_equations.h"
#include "tool_path_stretcher/prior.h"

namespace tool_path_stretcher {

struct NormalEquations {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right_side;
};

/// One standard deviation of the pose as it is known from before: of the turn [rad] and of the
/// shift [m].
struct PoseDeviation {
  double angle;
  double distance;
};
PoseDeviation pose_deviation(const Surface& reference, const Mapping& mapping, const Prior& prior);

/// What is taken for granted: that the part is stiff, and what was known before.
/// @param centre [m, reference] about which the object grows
NormalEquations assumptions(const Mapping& mapping, const Prior& prior, const PoseDeviation& pose,
                            const Eigen::Vector3d& centre);

}  // namespace tool_path_stretcher
