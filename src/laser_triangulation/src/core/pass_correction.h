// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "pass_overlap.h"

namespace laser_triangulation {

/// A small rigid motion of one sweep, about its own middle: about a place far from it, a turn would
/// be a shift, too.
struct SweepMotion {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  //!< [m] the mean of its places
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();   //!< [m] of the centre
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();    //!< [rad] rotation vector, about the centre
};

/// The motions that bring the sweeps together.
struct PassCorrection {
  std::vector<SweepMotion> motions;  //!< one a sweep
  /// Of the whole correction, by the covariance it was given: the root of the squared deviations
  /// over their number. About 1 where the covariance is right.
  double deviations = 0;
};

/// Finds all motions at once: the surfaces of each pair come to lie in each other (point to plane,
/// robust against what does not fit), and the motions stay as small as their covariance wants them.
/// That holds what the surfaces do not: they do not slide along a plane.
/// @param overlaps the pairs that are used; others share too little to tell a motion
/// @param covariance of all motions, each about SweepMotion::centre, in their order: shift [m],
/// turn [rad] of each sweep
PassCorrection find_correction(const SharedPlaces& shared, const std::vector<PassOverlap>& overlaps,
                               const Eigen::MatrixXd& covariance);

/// The motion as a transform of points.
Eigen::Isometry3d transform(const SweepMotion& motion);

/// Moves each sweep, and where it was seen from.
void apply(const PassCorrection& correction, const std::vector<Sweep>& sweeps, ScanCloud& cloud);

}  // namespace laser_triangulation
