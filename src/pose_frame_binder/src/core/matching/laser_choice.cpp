// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/laser_choice.h"

#include <fmt/format.h>

namespace pose_frame_binder {
namespace {

constexpr std::uint8_t kLasers = 2;  // described by a mask

std::string names(std::uint8_t lasers) {
  if (lasers == 1) return "laser_0 alone was";
  if (lasers == 2) return "laser_1 alone was";
  return lasers == 0 ? "no laser was" : "laser_0 and laser_1 were";
}

}  // namespace

LaserChoice choose_laser(std::uint8_t lasers, std::uint8_t told) {
  const auto on = [lasers](int laser) { return (lasers >> laser & 1) != 0; };
  if (told < kLasers && on(told)) return {told, ""};
  const std::string were = names(lasers & 3) + " on with its pulse";
  if (told != kLaserUnknown)
    return {kLaserUnknown, fmt::format("the camera says laser_{}, but {}", told, were)};
  if (on(0) == on(1)) return {kLaserUnknown, were};
  return {static_cast<std::uint8_t>(on(0) ? 0 : 1), ""};
}

}  // namespace pose_frame_binder
