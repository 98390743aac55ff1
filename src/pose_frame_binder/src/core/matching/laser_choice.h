// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pose_frame_binder/types.h"

namespace pose_frame_binder {

/// The laser that drew a frame's line: the only one that was on with its pulse and that the camera
/// may mean.
struct LaserChoice {
  std::uint8_t laser = kLaserUnknown;  //!< index; kLaserUnknown: it is not certain
  std::string doubt;                   //!< why it is not; empty where it is
};

/// @param lasers mask of those that were on with the pulse
/// @param told index of the laser as the camera tells it, or kLaserUnknown
LaserChoice choose_laser(std::uint8_t lasers, std::uint8_t told);

}  // namespace pose_frame_binder
