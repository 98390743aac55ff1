// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace scan_cell_demo {

/// Measurements of an accepted path by the demo.
struct Figures {
  double cloud_rms = 0;                    //!< [m] of the worse cloud from the true surfaces
  double path_rms = 0;                     //!< [m] of the adapted path from the true one
  double path_max = 0;                     //!< [m] of the farthest waypoint
  bool worked = false;                     //!< the robot followed the path
  double tip_rms = 0;                      //!< [m] of the true tip's way from the true path
  double tip_max = 0;                      //!< [m] of the farthest waypoint
  std::uint64_t pulses = 0;                //!< sent to the camera
  std::uint64_t frames_bound = 0;          //!< to a pose
  std::uint64_t frames_accounted_for = 0;  //!< not bound, but named with a reason
};

/// Goals for an accepted path and its clouds; the defaults are the demo's.
struct Goals {
  double cloud_rms = 0.1e-3;  //!< [m] at most
  double path_rms = 0.2e-3;   //!< [m] at most
  double path_max = 0.5e-3;   //!< [m] at most
  double tip_rms = 0.3e-3;    //!< [m] at most
  double tip_max = 0.8e-3;    //!< [m] at most
};

/// The goals that were missed, one sentence each. Two further goals: every pulse is bound to a pose
/// or accounted for, and nearly all are bound.
std::vector<std::string> missed_goals(const Figures& figures, const Goals& goals);

}  // namespace scan_cell_demo
