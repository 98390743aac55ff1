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
  std::uint64_t pulses = 0;   //!< sent
  int rows = 128;             //!< of the image
  double lost_frames = 0;     //!< share that never leaves the camera
  double camera_latency = 0;  //!< [s] as the binder is told; in truth 0
};

/// What became of it.
struct AlternatingResult {
  std::uint64_t pulses = 0;          //!< sent
  std::uint64_t missed = 0;          //!< deadlines of the trigger
  std::uint64_t frames = 0;          //!< that came
  std::uint64_t bound = 0;           //!< of them
  std::uint64_t uncertain = 0;       //!< dropped since their laser is not certain
  std::uint64_t points[2] = {0, 0};  //!< of each laser
  std::uint64_t wrong = 0;           //!< points off the floor: of the other laser's plane
  double worst = 0;                  //!< [m] farthest from the floor of all points
  double swapped = 0;                //!< [m] nearest to the floor, had each frame the other laser
};

/// The chain without ROS: the trigger's pulses on the circuit's wire, the simulated camera on GigE
/// Vision, the peak detector, the binder and the triangulation.
/// @throw scan_cell_common::Error
AlternatingResult run(const AlternatingScan& scan);

}  // namespace scan_cell_demo
