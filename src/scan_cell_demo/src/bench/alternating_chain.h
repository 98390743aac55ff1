// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace scan_cell_demo {

/// A scan with alternating lasers over a floor of known height.
struct AlternatingScan {
  std::string config;         //!< folder config of scan_cell_sim
  double rate = 100;          //!< [Hz] of the pulses
  std::uint64_t pulses = 0;   //!< number of pulses sent
  int rows = 128;             //!< of the image
  double lost_frames = 0;     //!< share that never leaves the camera
  double camera_latency = 0;  //!< [s] given to the binder; the true value is 0
};

/// Counts and errors of the scan.
struct AlternatingResult {
  std::uint64_t pulses = 0;          //!< sent
  std::uint64_t missed = 0;          //!< deadlines missed by the trigger
  std::uint64_t frames = 0;          //!< received
  std::uint64_t bound = 0;           //!< of the frames
  std::uint64_t uncertain = 0;       //!< dropped because their laser is uncertain
  std::uint64_t points[2] = {0, 0};  //!< of each laser
  std::uint64_t wrong = 0;           //!< points off the floor: on the other laser's plane
  double worst = 0;                  //!< [m] farthest distance of a point from the floor
  double swapped = 0;                //!< [m] nearest to the floor, if the lasers were swapped
};

/// The chain without ROS: the trigger's pulses on the circuit's wire, the simulated camera on GigE
/// Vision, the peak detector, the binder and the triangulation.
/// @throw scan_cell_common::Error
AlternatingResult run(const AlternatingScan& scan);

}  // namespace scan_cell_demo
