// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "pass_planner/sweep.h"
#include "scan_cell_common/scanner/scanner_model.h"
#include "scan_cell_sim/scene.h"

namespace pass_planner {

/// The image that the simulated cell's camera reads out (launch/devices.launch).
constexpr int kRegionX = 336, kRegionY = 599;            // [px]
constexpr int kRegionWidth = 1024, kRegionHeight = 512;  // [px]

/// What a sweep truly gives: an image is rendered every 0.6 mm of its way (60 mm/s at 100 Hz); its
/// peaks are found with the settings of the simulated cell and triangulated.
/// @return points [m] in world
std::vector<Eigen::Vector3d> simulated_scan(const scan_cell_sim::Scene& scene,
                                            const scan_cell_common::ScannerModel& scanner,
                                            const Sweep& sweep);

/// The same of several sweeps, one after the other.
std::vector<Eigen::Vector3d> simulated_scan(const scan_cell_sim::Scene& scene,
                                            const scan_cell_common::ScannerModel& scanner,
                                            const std::vector<Sweep>& sweeps);

}  // namespace pass_planner
