// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_check/judge/way_speeds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace c4g_driver {
namespace {

using Kind = ToolFault::Kind;

constexpr double kBeyondSpeed = 1e-6;  // share of a speed beyond a limit; chosen

}  // namespace

void WaySpeeds::enter(const TrackPlace& place, const ToolLine& line) {
  length_ = line.length();
  turn_seconds_ = line.angle() / subject_.parameters.rotational_speed;
  wanted_ = subject_.motion.waypoints[place.waypoint].speed;
  seconds_ = std::max(length_ / wanted_, turn_seconds_);
  check_tool(place, "tip", length_);
}

/// @param rate [m] by the way
void WaySpeeds::check_tool(const TrackPlace& place, const std::string& name, double rate) {
  if (rate <= subject_.speed.most * seconds_ * (1 + kBeyondSpeed)) return;
  findings_.add(place, {Kind::kToolSpeed, rate / seconds_, "speed of the " + name}, [&] {
    return Said(
        fmt::format("{:g} m/s", rate / seconds_),
        fmt::format("the limit is {:g} m/s: {}", subject_.speed.most, subject_.speed.reason));
  });
}

void WaySpeeds::look(const TrackPlace& place) {
  if (subject_.speed.reduced) check_tool(place, "flange", place.flange_rate);
  const Joints seconds = place.rate.cwiseAbs().cwiseQuotient(subject_.robot.speed());
  int slow = 0;
  const double most = seconds.maxCoeff(&slow);
  take_slowest(place, most, slow);
  for (int joint = 0; joint < 6; ++joint) {
    if (seconds[joint] <= seconds_ * (1 + kBeyondSpeed)) continue;
    findings_.add(place, {Kind::kJointSpeed, seconds[joint] / seconds_, joint_name(joint), joint},
                  [&] { return too_fast(std::abs(place.rate[joint]), joint, most); });
  }
}

/// @param rate [rad] by the way
/// @param most [s] that the slowest joint takes
Said WaySpeeds::too_fast(double rate, int joint, double most) const {
  const std::string limit = fmt::format("the limit is {:g} rad/s: ", subject_.robot.speed()[joint]);
  const std::string value = fmt::format("{:g} rad/s", rate / seconds_);
  if (turn_seconds_ * wanted_ > length_) {  // the tool's turn determines the time
    return {value, limit + fmt::format("set rotational_speed to {:g} rad/s or less",
                                       subject_.parameters.rotational_speed * seconds_ / most)};
  }
  return {value + fmt::format(" at {:g} m/s of the tip", length_ / seconds_),
          limit + fmt::format("go at {:g} m/s or less there", length_ / most)};
}

void WaySpeeds::take_slowest(const TrackPlace& place, double joint_seconds, int joint) {
  if (length_ <= 0) return;
  const bool turn = turn_seconds_ > joint_seconds;
  const double speed = length_ / (turn ? turn_seconds_ : joint_seconds);
  if (slowest_ && slowest_->speed <= speed) return;
  slowest_ = {place.waypoint, place.way, speed, wanted_, turn ? 6 : joint};
}

}  // namespace c4g_driver
