// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "pass_overlap.h"

namespace laser_triangulation {

/// A small rigid motion of one sweep about its own middle. About a distant point, a rotation would
/// also be a shift.
struct SweepMotion {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  //!< [m] the mean of its places
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();   //!< [m] of the centre
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();    //!< [rad] rotation vector, about the centre
};

/// The motions that bring the sweeps together.
struct PassCorrection {
  std::vector<SweepMotion> motions;  //!< one per sweep
  /// RMS size of the whole correction in standard deviations of the given covariance. About 1 if
  /// the covariance is right.
  double deviations = 0;
};

/// Finds all motions at once. They align the surfaces of each pair (point to plane, robust against
/// outliers) and stay as small as their covariance demands. The covariance holds motions that the
/// surfaces do not: a plane does not slide along itself.
/// @param overlaps the pairs to use; others share too little to determine a motion
/// @param covariance of all motions, each about SweepMotion::centre, in their order: shift [m],
/// turn [rad] of each sweep
PassCorrection find_correction(const SharedPlaces& shared, const std::vector<PassOverlap>& overlaps,
                               const Eigen::MatrixXd& covariance);

/// The motion as a transform for points.
Eigen::Isometry3d transform(const SweepMotion& motion);

/// Moves each sweep and its viewpoints.
void apply(const PassCorrection& correction, const std::vector<Sweep>& sweeps, ScanCloud& cloud);

}  // namespace laser_triangulation
