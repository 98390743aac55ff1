// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "poses/pose_rules.h"
#include "scan_cell_common/errors/errors.h"

namespace pose_frame_binder {

using scan_cell_common::to_seconds;

namespace {

double length(const ConstantSpeed& motion) {
  return (motion.end.translation() - motion.start.translation()).norm();
}

void check_number(const char* name, double value, double most) {
  if (value > 0 && value <= most) return;
  throw scan_cell_common::InvalidParameter(fmt::format("constant_speed/{}", name),
                                           fmt::format("{}", value),
                                           fmt::format("give a number above 0, up to {}", most));
}

/// The settings' motion belongs to a single arming.
void check_first(std::uint32_t pass) {
  if (pass == 0) return;
  throw scan_cell_common::Refused(
      fmt::format("pass {}", pass + 1),
      "the parameters constant_speed/* describe the motion of the first arming only",
      "remove them (scan_cell gives the motion of each line), or scan one pass");
}

}  // namespace

void check(const ConstantSpeed& motion) {
  constexpr double kMaxSpeed = 100;    // [m/s] chosen: no cell is as fast
  constexpr double kMaxRate = 1e5;     // [Hz] chosen: no camera is as fast
  constexpr double kMinLength = 1e-4;  // [m] chosen: shorter ones give no direction
  constexpr double kHalfTurn = 1e-6;  // [rad] chosen: closer to half a turn, neither way is shorter
  check_number("speed", motion.speed, kMaxSpeed);
  check_number("frame_rate", motion.frame_rate, kMaxRate);
  if (!motion.start.matrix().allFinite() || !motion.end.matrix().allFinite()) {
    throw scan_cell_common::InvalidParameter(
        "constant_speed/start, end", "missing, or not poses",
        "give x, y, z [m] and a unit quaternion qx, qy, qz, qw");
  }
  if (length(motion) < kMinLength) {
    throw scan_cell_common::InvalidParameter(
        "constant_speed/start, end", "at the same position",
        "give two different positions: they define the direction");
  }
  const Eigen::AngleAxisd turn(motion.start.linear().transpose() * motion.end.linear());
  if (M_PI - std::abs(turn.angle()) < kHalfTurn) {
    throw scan_cell_common::InvalidParameter("constant_speed/start, end", "half a turn apart",
                                             "turn by less: both directions are equally short");
  }
}

void check(const Run& run, const Settings& settings) {
  if (settings.method != Method::kConstantSpeed) return;
  if (is_given(settings.constant_speed)) return check_first(run.pass);
  if (!run.motion) {
    throw scan_cell_common::Refused(
        fmt::format("pass {}", run.pass + 1),
        "an arc or a polyline, which constant_speed does not support",
        "scan it with binding:=interpolate, or as lines, one pass each");
  }
  check(*run.motion);
}

bool is_given(const ConstantSpeed& motion) {
  return motion.start.matrix().allFinite() || motion.end.matrix().allFinite() ||
         motion.speed != 0 || motion.frame_rate != 0;  // NaN too
}

std::optional<Eigen::Isometry3d> pose_along(const ConstantSpeed& motion, double way) {
  constexpr double kRounding = 1e-9;  // of the fraction, which is of order 1
  const double fraction = way / length(motion);
  if (fraction > 1 + kRounding) return std::nullopt;
  return scan_cell_common::interpolate(motion.start, motion.end, std::min(fraction, 1.0));
}

PoseAnswer calculated(const Eigen::Isometry3d& pose, const Pulse& pulse, double error_bound) {
  PoseAnswer answer;
  Match& match = answer.match.emplace();
  match.rule = Rule::kConstantSpeed;
  match.pulse = pulse;
  match.pose = pose;
  match.time_to_before = match.time_to_after = std::numeric_limits<double>::quiet_NaN();
  match.position_error_bound = error_bound;
  return answer;
}

PoseAnswer refuse_beyond_end() {
  return refuse(DropReason::kNoPoseAfter, "the motion has ended before it");
}

std::optional<PoseAnswer> ConstantSpeedRule::find(std::size_t index, const PulseLog& pulses,
                                                  const PoseLog&) const {
  const Pulse& pulse = pulses[index];
  if (pulses.run(index) != pulses.run(0))
    return refuse(DropReason::kNoPoseBefore, "the motion of a second arming is not known");
  const ConstantSpeed& motion = settings_.constant_speed;
  const Pulse& first = pulses[0];
  const double since_start = static_cast<double>(pulse.count - 1) / motion.frame_rate;
  const double since_first = static_cast<double>(pulse.count - first.count) / motion.frame_rate;
  const double off = to_seconds(pulse.time - first.time) - since_first;
  if (std::abs(off) > settings_.max_pose_gap) {
    return refuse(
        DropReason::kPoseGap,
        fmt::format("its pulse came {:.6g} s off a constant frame rate, at most {} s allowed", off,
                    settings_.max_pose_gap));
  }
  const auto moved = pose_along(motion, since_start * motion.speed);
  if (!moved) return refuse_beyond_end();
  // Seen from the object, the motion from start to `moved` moves the scanner the other way.
  const Eigen::Isometry3d pose =
      motion.object_moves ? motion.start * moved->inverse() * motion.start : *moved;
  return calculated(pose, pulse, motion.speed * std::abs(off));
}

}  // namespace pose_frame_binder
