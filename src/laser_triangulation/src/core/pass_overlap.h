// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "shared_places.h"

namespace laser_triangulation {

/// The distance between two sweeps where both saw the surface.
struct PassOverlap {
  Sweep one;
  Sweep other;
  std::size_t points = 0;  //!< number of points compared
  double median = 0;       //!< [m] absolute distance along the surface's normal
  double most = 0;         //!< [m] 95th percentile of the same
  std::size_t apart = 0;   //!< number of points farther off than kApart
  /// Number of points on patches of the surface whose median lies farther off than kShifted.
  std::size_t shifted = 0;
};

/// [m] The passes of the worst scanner ever calibrated agree to a third of this; chosen.
constexpr double kApart = 1e-3;
// [m] Chosen: the goal of 0.1 mm plus a robot's repeatability of 0.05 mm, twice, since both passes
// have them. The calibration's uncertainty does not include the robot.
constexpr double kShifted = 2 * (0.1e-3 + 0.05e-3);

/// Compares the sweeps in pairs: a point of one with the plane through the other's surface around
/// it. Skips edges, rims of shadows, the two sides of a wall, and what only one of them saw. Pairs
/// that share too little are left out.
std::vector<PassOverlap> compare_sweeps(const SharedPlaces& shared);

/// Sweeps that could not be compared with any other.
std::vector<Sweep> sweeps_alone(const SharedPlaces& shared,
                                const std::vector<PassOverlap>& overlaps);

/// Whether too many points of a pair lie apart for a rim of a shadow to explain it.
bool disagree(const PassOverlap& overlap);

/// Whether a pair, or a part of its surface too large to be noise, lies farther apart than
/// kShifted, as when one part moved beside others that did not.
bool is_shifted(const PassOverlap& overlap);

}  // namespace laser_triangulation
