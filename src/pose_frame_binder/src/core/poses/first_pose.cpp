// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "poses/pose_rules.h"

namespace pose_frame_binder {

using scan_cell_common::to_seconds;

/// Bound on the flange's distance from `used` at the pulse: the distance to the interpolated point
/// plus that point's own error; without a pose on the other side, the furthest that it can have
/// moved.
double FirstPoseRule::position_error(std::size_t used, Nanoseconds time,
                                     const PoseLog& poses) const {
  const bool before = poses[used].time <= time;
  const double away = std::abs(to_seconds(time - poses[used].time));
  if (before ? used + 1 == poses.size() : used == 0) return settings_.max_speed * away;
  const TimedPose& first = poses[before ? used : used - 1];
  const TimedPose& second = poses[before ? used + 1 : used];
  const double share = away / to_seconds(second.time - first.time);
  return share * (second.pose.translation() - first.pose.translation()).norm() +
         line_error(first, second, time, settings_);
}

PoseAnswer FirstPoseRule::take(std::size_t used, Rule rule, const Pulse& pulse,
                               const PoseLog& poses) const {
  const double after_pose = to_seconds(pulse.time - poses[used].time);
  if (std::abs(after_pose) > settings_.max_pose_gap) {
    return refuse_gap(std::abs(after_pose), settings_);
  }
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  PoseAnswer answer;
  Match& match = answer.match.emplace();
  match.rule = rule;
  match.pulse = pulse;
  match.pose = poses[used].pose;
  match.time_to_before = after_pose >= 0 ? after_pose : kNaN;
  match.time_to_after = after_pose <= 0 ? -after_pose : kNaN;
  match.position_error_bound = position_error(used, pulse.time, poses);
  return answer;
}

/// Thesis, section 6.2, on the merged time line. T: the poses from this pulse to the next. If T has
/// two or more, several poses fall on one frame, and the first of T keeps it. Otherwise the frame
/// belongs to the last pose at or before it, together with the other frames up to the next pose;
/// the first of these keeps the pose.
std::optional<PoseAnswer> FirstPoseRule::find(std::size_t index, const PulseLog& pulses,
                                              const PoseLog& poses) const {
  constexpr Nanoseconds kNever = std::numeric_limits<Nanoseconds>::max();
  const Pulse& pulse = pulses[index];
  const bool last = index + 1 == pulses.size();
  if (last && !pulses.ended()) return std::nullopt;
  const Nanoseconds next_pulse = last ? kNever : pulses[index + 1].time;

  const std::size_t first = poses.first_at_or_after(pulse.time);
  const bool two = first + 1 < poses.size();
  if (!poses.settled(two ? poses[first + 1].time : kNever)) return std::nullopt;
  if (two && poses[first + 1].time < next_pulse) {
    return take(first, Rule::kPosesShareFrame, pulse, poses);
  }
  const bool same_time = first < poses.size() && poses[first].time == pulse.time;
  if (first == 0 && !same_time) {
    return refuse(DropReason::kNoPoseBefore, "no pose was measured before the pulse");
  }
  const std::size_t held = same_time ? first : first - 1;
  if (index > 0 && pulses[index - 1].time >= poses[held].time) {
    return refuse(DropReason::kSharedPose,
                  fmt::format("an earlier pulse has the pose at {} ns", poses[held].time));
  }
  const bool shared = held + 1 == poses.size() ? !last : next_pulse < poses[held + 1].time;
  return take(held, shared ? Rule::kFramesSharePose : Rule::kOneToOne, pulse, poses);
}

}  // namespace pose_frame_binder
