// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "shared_places.h"

namespace laser_triangulation {

/// How far two sweeps lie apart where both saw the surface.
struct PassOverlap {
  Sweep one;
  Sweep other;
  std::size_t points = 0;  //!< of the other that were compared
  double median = 0;       //!< [m] distance along the surface's normal, without its sign
  double most = 0;         //!< [m] the same of 95 %
  std::size_t apart = 0;   //!< of the points: those further off than kApart
  /// Of the points: those on patches of the surface of which half lies further off than kShifted.
  std::size_t shifted = 0;
};

/// [m] Passes of the worst scanner that was ever calibrated agree to a third of it; chosen.
constexpr double kApart = 1e-3;
// [m] Chosen: twice the goal of 0.1 mm and a robot's repeatability of 0.05 mm, as both passes have
// them. The calibration's uncertainty knows nothing of the robot.
constexpr double kShifted = 2 * (0.1e-3 + 0.05e-3);

/// Compares the sweeps in pairs: a point of one with the plane through the other's surface around
/// it. Edges, rims of shadows, the two sides of a wall, and what only one of them saw are passed
/// over. Pairs that share too little are left out.
std::vector<PassOverlap> compare_sweeps(const SharedPlaces& shared);

/// Sweeps that could be compared with no other.
std::vector<Sweep> sweeps_alone(const SharedPlaces& shared,
                                const std::vector<PassOverlap>& overlaps);

/// Whether so many points of a pair lie apart that no rim of a shadow explains it.
bool disagree(const PassOverlap& overlap);

/// Whether a pair, or a part of the surface that is more than noise, lies further apart than
/// kShifted: a part that moved, beside others that did not.
bool is_shifted(const PassOverlap& overlap);

}  // namespace laser_triangulation
