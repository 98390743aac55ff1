// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "poses/pose_rules.h"

namespace pose_frame_binder {

using scan_cell_common::to_seconds;

PoseAnswer InterpolationRule::between(const TimedPose& before, const TimedPose& after,
                                      const Pulse& pulse) const {
  const double gap = to_seconds(after.time - before.time);
  if (gap > settings_.max_pose_gap) return refuse_gap(gap, settings_);
  PoseAnswer answer;
  Match& match = answer.match.emplace();
  match.rule = Rule::kInterpolated;
  match.pulse = pulse;
  match.pose = scan_cell_common::interpolate(before, after, pulse.time);
  match.time_to_before = to_seconds(pulse.time - before.time);
  match.time_to_after = to_seconds(after.time - pulse.time);
  match.position_error_bound = line_error(before, after, pulse.time, settings_);
  return answer;
}

std::optional<PoseAnswer> InterpolationRule::find(std::size_t index, const PulseLog& pulses,
                                                  const PoseLog& poses) const {
  const Pulse& pulse = pulses[index];
  const std::size_t after = poses.first_at_or_after(pulse.time);
  if (after == poses.size()) {
    if (!poses.ended()) return std::nullopt;
    return refuse(poses.size() == 0 ? DropReason::kNoPoseBefore : DropReason::kNoPoseAfter,
                  fmt::format("the last of {} poses is earlier", poses.size()));
  }
  if (!poses.settled(poses[after].time)) return std::nullopt;
  if (poses[after].time == pulse.time) return between(poses[after], poses[after], pulse);
  if (after == 0) {
    return refuse(DropReason::kNoPoseBefore, fmt::format("the first pose is {:.6g} s later",
                                                         to_seconds(poses[0].time - pulse.time)));
  }
  return between(poses[after - 1], poses[after], pulse);
}

}  // namespace pose_frame_binder
