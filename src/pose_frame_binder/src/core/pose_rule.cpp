// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_frame_binder/pose_rule.h"

#include <cmath>
#include <limits>

namespace pose_frame_binder {
namespace {

using scan_cell_common::to_seconds;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

PoseAnswer refuse(DropReason reason, const std::string& detail) {
  PoseAnswer answer;
  answer.reason = reason;
  answer.detail = detail;
  return answer;
}

PoseAnswer refuse_gap(double gap, const Settings& settings) {
  return refuse(DropReason::PoseGap, std::to_string(gap) + " s, at most " +
                                         std::to_string(settings.most_pose_gap) + " s allowed");
}

/// How far the true path may be from the straight line between two measured positions, at `time`
/// between them: a t (T - t) / 2 for an acceleration of at most a (error of linear interpolation).
double line_error(const TimedPose& before, const TimedPose& after, Nanoseconds time,
                  const Settings& settings) {
  return settings.most_acceleration / 2 * to_seconds(time - before.time) *
         to_seconds(after.time - time);
}

PoseAnswer interpolated(const TimedPose& before, const TimedPose& after, const Pulse& pulse,
                        const Settings& settings) {
  const double gap = to_seconds(after.time - before.time);
  if (gap > settings.most_pose_gap) return refuse_gap(gap, settings);
  Match match;
  match.rule = Rule::Interpolated;
  match.pulse = pulse;
  match.pose = scan_cell_common::interpolate(before, after, pulse.time);
  match.time_to_before = to_seconds(pulse.time - before.time);
  match.time_to_after = to_seconds(after.time - pulse.time);
  match.position_error_bound = line_error(before, after, pulse.time, settings);
  PoseAnswer answer;
  answer.match = match;
  return answer;
}

std::optional<PoseAnswer> interpolate(const Pulse& pulse, const PoseLog& poses,
                                      const Settings& settings) {
  const std::size_t after = poses.first_at_or_after(pulse.time);
  if (after == poses.size()) {
    if (!poses.ended()) return std::nullopt;
    return refuse(poses.size() == 0 ? DropReason::NoPoseBefore : DropReason::NoPoseAfter,
                  "the last of " + std::to_string(poses.size()) + " poses is earlier");
  }
  if (!poses.settled(poses[after].time)) return std::nullopt;
  if (poses[after].time == pulse.time) {
    return interpolated(poses[after], poses[after], pulse, settings);
  }
  if (after == 0) {
    return refuse(
        DropReason::NoPoseBefore,
        "the first pose is " + std::to_string(to_seconds(poses[0].time - pulse.time)) + " s later");
  }
  return interpolated(poses[after - 1], poses[after], pulse, settings);
}

/// How far the flange was from `used` at the pulse: from there to the point between the poses, and
/// that point's own error; without a pose on the other side, what it can have gone.
double first_pose_error(std::size_t used, Nanoseconds time, const PoseLog& poses,
                        const Settings& settings) {
  const bool before = poses[used].time <= time;
  const double away = std::abs(to_seconds(time - poses[used].time));
  if (before ? used + 1 == poses.size() : used == 0) return settings.most_speed * away;
  const TimedPose& first = poses[before ? used : used - 1];
  const TimedPose& second = poses[before ? used + 1 : used];
  const double share = away / to_seconds(second.time - first.time);
  return share * (second.pose.translation() - first.pose.translation()).norm() +
         line_error(first, second, time, settings);
}

PoseAnswer take_pose(std::size_t used, Rule rule, const Pulse& pulse, const PoseLog& poses,
                     const Settings& settings) {
  const double after_pose = to_seconds(pulse.time - poses[used].time);
  if (std::abs(after_pose) > settings.most_pose_gap) {
    return refuse_gap(std::abs(after_pose), settings);
  }
  Match match;
  match.rule = rule;
  match.pulse = pulse;
  match.pose = poses[used].pose;
  match.time_to_before = after_pose >= 0 ? after_pose : kNaN;
  match.time_to_after = after_pose <= 0 ? -after_pose : kNaN;
  match.position_error_bound = first_pose_error(used, pulse.time, poses, settings);
  PoseAnswer answer;
  answer.match = match;
  return answer;
}

/// Thesis, section 6.2, on the merged time line. T: the poses from this pulse to the next. Two or
/// more: several poses on one frame, the first of T keeps it. Otherwise the frame belongs to the
/// last pose at or before it, together with the other frames up to the next pose, of which the
/// first keeps it.
std::optional<PoseAnswer> first_pose(std::size_t index, const PulseLog& pulses,
                                     const PoseLog& poses, const Settings& settings) {
  constexpr Nanoseconds kNever = std::numeric_limits<Nanoseconds>::max();
  const Pulse& pulse = pulses[index];
  const bool last = index + 1 == pulses.size();
  if (last && !pulses.ended()) return std::nullopt;
  const Nanoseconds next_pulse = last ? kNever : pulses[index + 1].time;

  const std::size_t first = poses.first_at_or_after(pulse.time);
  const bool two = first + 1 < poses.size();
  if (!poses.settled(two ? poses[first + 1].time : kNever)) return std::nullopt;
  if (two && poses[first + 1].time < next_pulse) {
    return take_pose(first, Rule::PosesShareFrame, pulse, poses, settings);
  }
  const bool same_time = first < poses.size() && poses[first].time == pulse.time;
  if (first == 0 && !same_time) {
    return refuse(DropReason::NoPoseBefore, "no pose was measured up to the pulse");
  }
  const std::size_t held = same_time ? first : first - 1;
  if (index > 0 && pulses[index - 1].time >= poses[held].time) {
    return refuse(DropReason::SharedPose,
                  "an earlier pulse keeps the pose of " + std::to_string(poses[held].time) + " ns");
  }
  const bool shared = held + 1 == poses.size() ? !last : next_pulse < poses[held + 1].time;
  return take_pose(held, shared ? Rule::FramesSharePose : Rule::OneToOne, pulse, poses, settings);
}

}  // namespace

std::optional<PoseAnswer> find_pose(std::size_t pulse, const PulseLog& pulses, const PoseLog& poses,
                                    const Settings& settings) {
  return settings.method == Method::FirstPose ? first_pose(pulse, pulses, poses, settings)
                                              : interpolate(pulses[pulse], poses, settings);
}

}  // namespace pose_frame_binder
