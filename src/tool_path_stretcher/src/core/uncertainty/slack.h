// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "uncertainty/assumptions.h"

namespace tool_path_stretcher {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Motions = Eigen::Matrix<double, 3, 6>;

/// The centre of rotation [m, reference], and the arm that converts a rotation to a length [m].
struct Turns {
  Eigen::Vector3d centre;
  double size;
};

/// The motion of a point under a rotation (that moves a point at the arm's length by one metre) and
/// a shift.
Motions rigid_motions(const Eigen::Vector3d& point, const Turns& turns);

/// How constraints of one kind hold the rigid motions.
struct Held {
  Matrix6d all = Matrix6d::Zero();       // if each direction were exact
  Matrix6d steadily = Matrix6d::Zero();  // by the steady directions
  Matrix6d noise = Matrix6d::Zero();     // the part of that held by their noise
};

/// Directions far less steady than most, as beside edges and at loose points, are assumed to hold
/// nothing.
/// @param off [rad] error of each direction
/// @param weight [1/m^2] of each
Held held_by(const std::vector<GraphConstraint>& constraints, const std::vector<double>& off,
             double weight, const Turns& turns);

/// What the covariance of the rigid motions lacks because the noise of the normals seems to hold
/// motions that nothing holds: a moulding's normals all lie in one plane, and noise tilts them out
/// of it. Edges of a mesh hold the part whatever the normals do; the end of a scan may not be an
/// edge.
/// @param pose prior
Matrix6d seemingly_held(const Held& normals, const Held& rims, bool edges_are_known,
                        const Turns& turns, const PoseDeviation& pose);

}  // namespace tool_path_stretcher
