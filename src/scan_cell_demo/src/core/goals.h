// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace scan_cell_demo {

/// What the demo measures of an accepted path.
struct Figures {
  double cloud_rms = 0;                    //!< [m] of the worse cloud from the true surfaces
  double path_rms = 0;                     //!< [m] of the adapted path from the true one
  std::uint64_t pulses = 0;                //!< sent to the camera
  std::uint64_t frames_bound = 0;          //!< to a pose
  std::uint64_t frames_accounted_for = 0;  //!< not bound, named with a reason
};

/// The goals that were missed, one sentence each: 0.3 mm RMS of the clouds, 1 mm RMS of the path,
/// every pulse bound to a pose or accounted for, and nearly all of them bound.
std::vector<std::string> missed_goals(const Figures& figures);

}  // namespace scan_cell_demo
