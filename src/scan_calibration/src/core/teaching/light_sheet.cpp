// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "teaching/light_sheet.h"

#include <algorithm>
#include <cmath>

#include "teaching/calibrated_frames.h"

namespace scan_calibration {

std::array<Eigen::Vector3d, 3> light_sheet(const scan_cell_common::LaserPlane& laser,
                                           const std::string& name, const SheetSize& size) {
  const Eigen::Isometry3d frame = laser_frame(laser, name);
  const double depth = laser.distance / laser.normal.z();  // of the crossing with the optical axis
  const double to_axis = (frame.inverse() * Eigen::Vector3d(0, 0, depth)).z();
  const double length = size.length > 0 ? size.length : to_axis;
  const double half_width = length * std::tan(size.opening / 2);
  return {Eigen::Vector3d::Zero(), {0, -half_width, length}, {0, half_width, length}};
}

void BurningLasers::burn(std::uint8_t lasers, double now) {
  for (std::size_t i = 0; i < kLasers; ++i) {
    if ((lasers >> i & 1) != 0) until_[i] = now + silence_;
  }
}

void BurningLasers::on_state(bool armed, std::uint8_t lasers, double rate, double now) {
  constexpr double kPeriods = 5;  // the first pulse comes after one, or after four; chosen
  dark_ = !armed;
  until_.fill(0);
  if (dark_) return;
  silence_ = rate > 0 ? std::max(kShortestSilence, kPeriods / rate) : kShortestSilence;
  burn(lasers, now);
}

void BurningLasers::on_pulse(std::uint8_t lasers, double now) {
  if (!dark_) burn(lasers, now);  // else it was on its way when the lasers went off
}

}  // namespace scan_calibration
