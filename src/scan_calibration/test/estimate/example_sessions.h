// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "estimate/synthetic_session.h"
#include "estimate/truth_comparison.h"
#include "scan_calibration/calibration.h"

/// Sessions of an ordinary cell, for most tests of the estimate.
namespace synthetic {

inline const Noise kNoise = {0.1, 0.1, 5e-5, 5e-5};

inline std::vector<Eigen::Isometry3d> some_poses(const Cell& cell, int count, unsigned seed = 1) {
  Poses poses;
  poses.count = count;
  poses.seed = seed;
  return flange_poses(cell, poses);
}

inline scan_calibration::Observations some_views(int count, unsigned seed = 1) {
  const Cell cell;
  return observe(cell, some_poses(cell, count, seed), kNoise, seed);
}

/// Moves each corner of the view by 1 px (RMS) along either axis.
inline void spoil_corners(scan_calibration::ViewObservation& view) {
  std::mt19937 generator(1);
  std::normal_distribution<double> error(0, 1);
  for (scan_calibration::SeenCorner& corner : view.corners) {
    const double x = error(generator);
    corner.pixel += Eigen::Vector2d(x, error(generator));
  }
}

inline void expect_true(const Cell& cell, const scan_calibration::Calibration& calibration) {
  constexpr double kDeviations = 4.5;  // of 29 parameters, of which one in 5000 sessions would
  const auto [miss, name] = worst_miss(cell, calibration);
  EXPECT_LT(miss, kDeviations) << name;
}

}  // namespace synthetic
