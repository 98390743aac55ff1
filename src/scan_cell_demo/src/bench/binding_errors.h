// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "laser_triangulation/triangulator.h"
#include "scan_cell_sim/scene.h"
#include "simulated_cell.h"

namespace scan_cell_demo {

/// Error of a cloud with the poses of one method of binding.
struct CloudError {
  double to_surface = 0;  //!< [m] RMS distance of the points from the part's true surface
  double to_perfect = 0;  //!< [m] RMS distance from the same peaks placed by the true poses
};

struct MedianAndMax {
  double median = 0, max = 0;
};

/// True delay [s] of the pulses' stamps against the simulated camera's clock, which is the host's.
/// The maximum is the greatest in either direction.
MedianAndMax pulse_delay(const Scan& scan);

/// One cloud per method of binding, from the same peaks of the same frames: frames taken while the
/// robot moved and bound by both binders. Only points on the part count.
struct BindingErrors {
  std::size_t frames = 0;
  std::size_t points = 0;
  MedianAndMax speed;         //!< [m/s] of the middle of the line of light, by the true poses
  MedianAndMax acceleration;  //!< [m/s^2] of it
  CloudError perfect;         //!< the true pose at the frame's instant
  CloudError interpolated;
  CloudError first_pose;
};

/// @param part its surface only; the board plane is z = 0
/// @throw scan_cell_common::UnusableInput if no frame or no point is left
BindingErrors compare(const Scan& scan, const scan_cell_common::ScannerModel& scanner,
                      const laser_triangulation::PeakLimits& limits,
                      const scan_cell_sim::Scene& part);

/// True delay [s] of the scan's poses against its pulses: least-squares fit of the lag of the
/// interpolated poses behind the true ones, along their velocities.
double true_pose_delay(const Scan& scan);

}  // namespace scan_cell_demo
