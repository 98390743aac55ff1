// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_frame_binder/pose_rule.h"

#include "poses/pose_rules.h"
#include "scan_cell_common/errors.h"

namespace pose_frame_binder {

using scan_cell_common::to_seconds;

Method method_from(const std::string& word) {
  if (word == "interpolate") return Method::Interpolate;
  if (word == "first_pose") return Method::FirstPose;
  if (word == "constant_speed") return Method::ConstantSpeed;
  throw scan_cell_common::InvalidParameter("method", "'" + word + "'",
                                           "give interpolate, first_pose or constant_speed");
}

std::unique_ptr<PoseRule> make_pose_rule(const Settings& settings) {
  switch (settings.method) {
    case Method::FirstPose:
      return std::make_unique<FirstPoseRule>(settings);
    case Method::ConstantSpeed:
      return std::make_unique<ConstantSpeedRule>(settings);
    case Method::Interpolate:
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
  return refuse(DropReason::PoseGap, std::to_string(gap) + " s, at most " +
                                         std::to_string(settings.most_pose_gap) + " s allowed");
}

double line_error(const TimedPose& before, const TimedPose& after, Nanoseconds time,
                  const Settings& settings) {
  return settings.most_acceleration / 2 * to_seconds(time - before.time) *
         to_seconds(after.time - time);
}

}  // namespace pose_frame_binder
