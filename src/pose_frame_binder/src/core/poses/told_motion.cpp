// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "poses/pose_rules.h"
#include "scan_cell_common/errors/errors.h"

namespace pose_frame_binder {

using scan_cell_common::to_seconds;

namespace {

/// Way [m] along the line to the point nearest to `position`.
double way_to(const Eigen::Vector3d& position, const ConstantSpeed& motion) {
  const Eigen::Vector3d line = motion.end.translation() - motion.start.translation();
  const double way = (position - motion.start.translation()).dot(line.normalized());
  return std::clamp(way, 0.0, line.norm());
}

}  // namespace

void ToldMotionRule::start_run(const std::optional<ConstantSpeed>& motion) {
  runs_.push_back(motion.value());
}

void ToldMotionRule::check_told(std::uint32_t run) const {
  if (run < runs_.size()) return;
  throw scan_cell_common::Refused("constant_speed", "the motion was not given",
                                  "scan with scan_cell, which gives it, set constant_speed/start, "
                                  "end, speed and frame_rate, or use another method");
}

std::optional<PoseAnswer> ToldMotionRule::find(std::size_t index, const PulseLog& pulses,
                                               const PoseLog& poses) const {
  const Pulse& pulse = pulses[index];
  const std::uint32_t run = pulses.run(index);
  if (run >= runs_.size()) return refuse(DropReason::kNoPoseBefore, "its motion was not given");
  const ConstantSpeed& motion = runs_[run];
  const std::size_t first = pulses.first_of(run);
  const std::optional<PoseAnswer> at_first = measured_.find(first, pulses, poses);
  const std::optional<PoseAnswer> at_pulse = measured_.find(index, pulses, poses);
  if (!at_first || !at_pulse) return std::nullopt;

  const double before = static_cast<double>(pulses[first].count - 1) / motion.frame_rate;
  const double begin =
      at_first->match ? way_to(at_first->match->pose.translation(), motion) : before * motion.speed;
  const double since_first = to_seconds(pulse.time - pulses[first].time);
  const auto pose = pose_along(motion, begin + since_first * motion.speed);
  if (!pose) return refuse_beyond_end();
  if (!at_pulse->match) return calculated(*pose, pulse, 0);
  const double off = (at_pulse->match->pose.translation() - pose->translation()).norm();
  if (off > settings_.max_pose_gap * motion.speed) {
    return refuse(DropReason::kPoseGap,
                  fmt::format("the robot was measured {:.6g} m from it, at most {:.6g} m allowed: "
                              "it did not move at a constant {} m/s",
                              off, settings_.max_pose_gap * motion.speed, motion.speed));
  }
  return calculated(*pose, pulse, off);
}

}  // namespace pose_frame_binder
