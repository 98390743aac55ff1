// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace scan_cell_rviz {

enum class Level {
  kGood,
  kNotice,  //!< somebody should know
  kBad,     //!< nothing goes until it is mended
  kGone,    //!< its node says nothing
  kLaser,   //!< a laser is on
};

/// What the band says of a device.
struct Sign {
  Level level = Level::kGone;
  std::string text;

  bool operator==(const Sign& other) const { return level == other.level && text == other.text; }
};

/// What the band has a sign for, from left to right.
enum class Device { kRobot, kCamera, kLaser, kCell, kCalibration };
constexpr int kDevices = 5;

}  // namespace scan_cell_rviz
