// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "laser_triangulation/triangulator.h"
#include "scan_cell_sim/scene.h"
#include "simulated_cell.h"

namespace scan_cell_demo {

/// How a cloud came out with the poses of one way of binding.
struct CloudError {
  double to_surface = 0;  //!< [m] r.m.s. distance of the points from the part's true surface
  double to_perfect = 0;  //!< [m] r.m.s. distance from where the true poses put the same peaks
};

struct MedianAndMost {
  double median = 0, most = 0;
};

/// How late [s] the pulses were stamped in truth: against the simulated camera's clock, which is
/// the host's. Most: the worst, either way.
MedianAndMost pulse_delay(const Scan& scan);

/// One cloud a way of binding, of the same peaks of the same frames: those taken while the robot
/// moved that both binders bound. Points on the part alone.
struct BindingErrors {
  std::size_t frames = 0;
  std::size_t points = 0;
  MedianAndMost speed;         //!< [m/s] of the middle of the line of light, by the true poses
  MedianAndMost acceleration;  //!< [m/s^2] of it
  CloudError perfect;          //!< the true pose at the frame's instant
  CloudError interpolated;
  CloudError first_pose;
};

/// @param part its surface alone; the board plane is z = 0
/// @throw scan_cell_common::UnusableInput if no frame or no point is left
BindingErrors compare(const Scan& scan, const scan_cell_common::ScannerModel& scanner,
                      const laser_triangulation::PeakLimits& limits,
                      const scan_cell_sim::Scene& part);

/// How late [s] the scan's poses were stamped in truth, against its pulses: least squares of how
/// far the interpolated poses lie behind the true ones, along their velocities.
double true_pose_delay(const Scan& scan);

}  // namespace scan_cell_demo
