// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "poses/pose_rule.h"

#include <fmt/format.h>

#include "poses/pose_rules.h"

namespace pose_frame_binder {

using scan_cell_common::to_seconds;

std::unique_ptr<PoseRule> make_pose_rule(const Settings& settings) {
  switch (settings.method) {
    case Method::kFirstPose:
      return std::make_unique<FirstPoseRule>(settings);
    case Method::kConstantSpeed:
      if (is_given(settings.constant_speed)) return std::make_unique<ConstantSpeedRule>(settings);
      return std::make_unique<ToldMotionRule>(settings);
    case Method::kInterpolate:
      break;
  }
  return std::make_unique<InterpolationRule>(settings);
}

PoseAnswer refuse(DropReason reason, const std::string& detail) {
  PoseAnswer answer;
  answer.reason = reason;
  answer.detail = detail;
  return answer;
}

PoseAnswer refuse_gap(double gap, const Settings& settings) {
  return refuse(DropReason::kPoseGap,
                fmt::format("{:.6g} s, at most {} s allowed", gap, settings.max_pose_gap));
}

double line_error(const TimedPose& before, const TimedPose& after, Nanoseconds time,
                  const Settings& settings) {
  return settings.max_acceleration / 2 * to_seconds(time - before.time) *
         to_seconds(after.time - time);
}

}  // namespace pose_frame_binder
