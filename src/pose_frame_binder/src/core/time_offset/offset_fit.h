// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace pose_frame_binder {

/// residual + slope . (delay, two shifts across the motion) = 0 if the two scans agree.
struct OffsetPair {
  Eigen::Vector3d slope;        //!< [m/s], two cosines
  Eigen::Matrix3d slope_noise;  //!< its covariance
  double residual;              //!< [m]
  bool on_relief;
  int block;  //!< of the scene, along the motion
};

struct OffsetFit {
  Eigen::Vector3d solution = Eigen::Vector3d::Zero();  //!< delay [s], two shifts [m]
  double from_posterior = 0;                           //!< [s] deviation of the delay
  double from_residuals = 0;                           //!< [s]
};

/// Iteratively reweighted least squares with Tukey's weights.
OffsetFit fit_offset(const std::vector<OffsetPair>& pairs);

}  // namespace pose_frame_binder
