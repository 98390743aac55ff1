// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_calibration {

/// How much of a laser's fan is drawn. The scanner model has its plane, but not where it ends.
struct SheetSize {
  double opening = 0.7854;  //!< [rad] angle of the fan at the projector; 45 degrees: chosen
  double length = 0;        //!< [m] along its middle; 0: to where it crosses the optical axis
};

/// The sheet of light of a laser as a triangle in laser_frame(): the projector, and the two ends of
/// the line of light that it throws.
/// @throw scan_cell_common::UnusableInput as laser_frame()
std::array<Eigen::Vector3d, 3> light_sheet(const scan_cell_common::LaserPlane& laser,
                                           const std::string& name, const SheetSize& size);

/// Which lasers burn, from what the trigger's node says. Its pulses are the sign that it lives: a
/// node that was killed cannot say that its lasers went off.
class BurningLasers {
 public:
  static constexpr std::size_t kLasers = 8;  //!< bits of a mask

  /// Its state changed.
  /// @param lasers bit mask of those that are on, or take turns
  /// @param rate [Hz] of the pulses to come
  /// @param now [s] on any clock that never goes back
  void on_state(bool armed, std::uint8_t lasers, double rate, double now);

  /// It sent a pulse while `lasers` were on. Without a state, as in a bag, pulses alone tell.
  void on_pulse(std::uint8_t lasers, double now);

  /// Whether laser_<index> burns.
  bool burns(std::size_t index, double now) const { return now < until_.at(index); }

 private:
  static constexpr double kShortestSilence = 0.5;  // [s] 500 times a usual period; chosen

  void burn(std::uint8_t lasers, double now);

  bool dark_ = false;                  // it said that it is disarmed
  double silence_ = kShortestSilence;  // [s] without a pulse, after which they count as off
  std::array<double, kLasers> until_ = {};
};

}  // namespace scan_calibration
