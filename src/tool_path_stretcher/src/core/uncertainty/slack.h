// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "uncertainty/assumptions.h"

namespace tool_path_stretcher {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Motions = Eigen::Matrix<double, 3, 6>;

/// The centre of turns [m, reference], and the arm that makes a turn as long as a shift [m].
struct Turns {
  Eigen::Vector3d centre;
  double size;
};

/// How a point moves with a turn (of a point at the arm's length by one metre) and a shift.
Motions rigid_motions(const Eigen::Vector3d& point, const Turns& turns);

/// What constraints of one kind hold of the rigid motions.
struct Held {
  Matrix6d all = Matrix6d::Zero();       // if each direction was exact
  Matrix6d steadily = Matrix6d::Zero();  // of the steady ones
  Matrix6d noise = Matrix6d::Zero();     // of those, what their noise holds
};

/// Directions that are far less steady than most, as beside edges and in loose points, are not
/// taken to hold anything.
/// @param off [rad] how far each direction may be off
/// @param weight [1/m^2] of each
Held held_by(const std::vector<GraphConstraint>& constraints, const std::vector<double>& off,
             double weight, const Turns& turns);

/// What the covariance of the rigid motions is short of, because the noise of the normals seems to
/// hold what nothing holds: a moulding's normals all lie in one plane, and noise tilts them out of
/// it. Edges of a mesh hold what they hold whatever the normals do; where a scan ends may be no
/// edge.
/// @param pose as it was known before
Matrix6d seemingly_held(const Held& normals, const Held& rims, bool edges_are_known,
                        const Turns& turns, const PoseDeviation& pose);

}  // namespace tool_path_stretcher
