// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_calibration {

/// How much of a laser's fan is drawn. The scanner model has its plane, but not its ends.
struct SheetSize {
  double opening = 0.7854;  //!< [rad] angle of the fan at the projector; 45 degrees: chosen
  double length = 0;        //!< [m] along its middle; 0: to the optical axis
};

/// The sheet of light of a laser as a triangle in laser_frame(): the projector, and the two ends of
/// the line of light.
/// @throw scan_cell_common::UnusableInput as laser_frame()
std::array<Eigen::Vector3d, 3> light_sheet(const scan_cell_common::LaserPlane& laser,
                                           const std::string& name, const SheetSize& size);

/// Tracks which lasers burn, from the messages of the trigger's node. Pulses are its sign of life:
/// a node that was killed cannot report that its lasers went off.
class BurningLasers {
 public:
  static constexpr std::size_t kLasers = 8;  //!< bits of a mask

  /// The trigger's state changed.
  /// @param lasers bit mask of those that are on or take turns
  /// @param rate [Hz] of the pulses to come
  /// @param now [s] on any clock that never goes back
  void on_state(bool armed, std::uint8_t lasers, double rate, double now);

  /// The trigger sent a pulse while `lasers` were on. Without a state, as in a bag, only pulses
  /// count.
  void on_pulse(std::uint8_t lasers, double now);

  /// Whether laser_<index> burns.
  bool burns(std::size_t index, double now) const { return now < until_.at(index); }

 private:
  static constexpr double kShortestSilence = 0.5;  // [s] 500 times a usual period; chosen

  void burn(std::uint8_t lasers, double now);

  bool dark_ = false;                  // the trigger reported that it is disarmed
  double silence_ = kShortestSilence;  // [s] without a pulse, after which they count as off
  std::array<double, kLasers> until_ = {};
};

}  // namespace scan_calibration
