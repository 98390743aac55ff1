// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

namespace scan_cell {

/// One pose of a calibration session.
struct TaughtPose {
  std::string name;                                          //!< for messages, such as "line 12"
  Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();  //!< tool0 in the robot's base frame
};

/// What to record for a calibration.
struct SessionRequest {
  std::vector<TaughtPose> poses;
  std::uint8_t lasers = 0;    //!< bit mask: each is on in turn; 0: the board only
  double board_exposure = 0;  //!< [s] of the board's image, lasers off
  double line_exposure = 0;   //!< [s] of the images of laser lines
};

/// What the cell allows.
struct SessionLimits {
  double min_exposure = 1e-6;  //!< [s]
  double max_exposure = 0.4;   //!< [s] the pulse period is at least twice that
};

/// Indices of the lasers in a bit mask, ascending.
std::vector<int> lasers_in(std::uint8_t mask);

/// @throw scan_cell_common::Refused naming what is out of range
void check(const SessionRequest& request, const SessionLimits& limits);

}  // namespace scan_cell
