// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "pass_planner/sweep.h"
#include "scan_cell_common/scanner/scanner_model.h"
#include "scan_cell_sim/ground_truth.h"
#include "scan_cell_sim/world.h"

namespace pass_planner {

/// Places that a program sees at these angles, and how many of them have a scanned point.
struct AngleCoverage {
  double max_angle = 0;    //!< [rad] of light and sight to the normal, in the best sweep; no more
  std::size_t places = 0;  //!< above the angle of the entry before
  std::size_t there = 0;   //!< of these
};

/// How much of the parts' surfaces a cloud holds.
struct Coverage {
  std::vector<AngleCoverage> by_angle;  //!< up to a right angle
  scan_cell_sim::CloudError error;      //!< of the cloud from all surfaces of the world

  /// Share of the places seen up to an angle [rad] that have a scanned point; 1 if there is none.
  double share(double max_angle) const;
};

constexpr double kThere = 1.5e-3;  //!< [m] of a scanned point from a place that is there; chosen

/// Compares a cloud with the surface that its program can see: not shadowed, inside the simulated
/// cell's image, and passed by a plane of light. The surface is sampled with one place every 1.5
/// mm.
/// @param passes, cloud [m] in world
Coverage measure_coverage(const scan_cell_sim::World& world,
                          const std::vector<scan_cell::ScanPass>& passes,
                          const scan_cell_common::ScannerModel& scanner,
                          const std::vector<Eigen::Vector3d>& cloud);

}  // namespace pass_planner
