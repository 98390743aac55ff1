// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

namespace scan_cell {

/// A scan along one line.
struct ScanRequest {
  std::string scan_id;                                      //!< its name; empty: made from the time
  Eigen::Isometry3d start = Eigen::Isometry3d::Identity();  //!< tool0 in the robot's base frame
  Eigen::Isometry3d end = Eigen::Isometry3d::Identity();    //!< tool0 in the robot's base frame
  double speed = 0;                                         //!< [m/s]
  double rate = 0;                                          //!< [Hz] frames
  std::uint8_t lasers = 0;                                  //!< bit mask, one bit
};

/// What the cell allows.
struct ScanLimits {
  double max_speed = 0.5;    //!< [m/s]
  double min_rate = 2;       //!< [Hz] a camera that is slower cannot be watched
  double max_rate = 500;     //!< [Hz]
  double max_length = 2.0;   //!< [m]
  double min_length = 1e-3;  //!< [m]
};

/// @throw scan_cell_common::Refused naming what is out of range
void check(const ScanRequest& request, const ScanLimits& limits);

}  // namespace scan_cell
