// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pose_frame_binder/types.h"

namespace pose_frame_binder {

/// The laser that drew a frame's line: the only one that was on with its pulse and does not
/// contradict the camera.
struct LaserChoice {
  std::uint8_t laser = kLaserUnknown;  //!< index; kLaserUnknown: uncertain
  std::string doubt;                   //!< why it is uncertain; empty: it is certain
};

/// @param lasers mask of the lasers that were on with the pulse
/// @param told index of the laser as the camera tells it, or kLaserUnknown
LaserChoice choose_laser(std::uint8_t lasers, std::uint8_t told);

}  // namespace pose_frame_binder
