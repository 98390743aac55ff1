// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "poses/pose_rule.h"

namespace pose_frame_binder {

/// Between the last pose before and the first pose at or after the pulse.
class InterpolationRule : public PoseRule {
 public:
  explicit InterpolationRule(const Settings& settings) : settings_(settings) {}
  std::optional<PoseAnswer> find(std::size_t pulse, const PulseLog& pulses,
                                 const PoseLog& poses) const override;

 private:
  PoseAnswer between(const TimedPose& before, const TimedPose& after, const Pulse& pulse) const;

  const Settings settings_;
};

/// Thesis, section 6.2, on the merged time line of poses and pulses.
class FirstPoseRule : public PoseRule {
 public:
  explicit FirstPoseRule(const Settings& settings) : settings_(settings) {}
  std::optional<PoseAnswer> find(std::size_t pulse, const PulseLog& pulses,
                                 const PoseLog& poses) const override;

 private:
  PoseAnswer take(std::size_t used, Rule rule, const Pulse& pulse, const PoseLog& poses) const;
  double position_error(std::size_t used, Nanoseconds time, const PoseLog& poses) const;

  const Settings settings_;
};

/// Thesis, section 6.1: from start to end at a constant speed, the first pulse at the start.
class ConstantSpeedRule : public PoseRule {
 public:
  explicit ConstantSpeedRule(const Settings& settings);
  void start_run(const std::optional<ConstantSpeed>& motion) override;
  std::optional<PoseAnswer> find(std::size_t pulse, const PulseLog& pulses,
                                 const PoseLog& poses) const override;

 private:
  std::optional<ConstantSpeed> motion_of(std::uint32_t run) const;

  const Settings settings_;
  std::vector<std::optional<ConstantSpeed>> runs_;  // as they were told
};

PoseAnswer refuse(DropReason reason, const std::string& detail);
PoseAnswer refuse_gap(double gap, const Settings& settings);

/// How far the true path may be from the straight line between two measured positions, at `time`
/// between them: a t (T - t) / 2 for an acceleration of at most a (error of linear interpolation).
double line_error(const TimedPose& before, const TimedPose& after, Nanoseconds time,
                  const Settings& settings);

}  // namespace pose_frame_binder
