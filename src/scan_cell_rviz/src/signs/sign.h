// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace scan_cell_rviz {

enum class Level {
  kGood,
  kNotice,  //!< somebody should know
  kBad,     //!< nothing works until it is repaired
  kGone,    //!< its node does not answer
  kLaser,   //!< a laser is on
};

/// The sign of a device in the band.
struct Sign {
  Level level = Level::kGone;
  std::string text;

  bool operator==(const Sign& other) const { return level == other.level && text == other.text; }
};

/// The devices in the band, from left to right.
enum class Device { kRobot, kCamera, kLaser, kCell, kCalibration };
constexpr int kDevices = 5;

}  // namespace scan_cell_rviz
