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

/// One standard deviation of the prior pose: of the rotation [rad] and of the shift [m].
struct PoseDeviation {
  double angle;
  double distance;
};
PoseDeviation pose_deviation(const Surface& reference, const Mapping& mapping, const Prior& prior);

/// The prior knowledge.
/// @param centre [m, reference] about which the object grows
NormalEquations knowledge(const Mapping& mapping, const Prior& prior, const PoseDeviation& pose,
                          const Eigen::Vector3d& centre);

/// The assumption that the part is stiff: a link is strained no more than the links were seen to
/// be.
NormalEquations rigidity(const Mapping& mapping, const Eigen::Vector3d& centre);

}  // namespace tool_path_stretcher
