// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "poses/pose_rule.h"

namespace pose_frame_binder {

/// Interpolates between the last pose before and the first pose at or after the pulse.
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

/// Thesis, section 6.1: from start to end at the settings' constant speed, the first pulse at the
/// start.
class ConstantSpeedRule : public PoseRule {
 public:
  explicit ConstantSpeedRule(const Settings& settings) : settings_(settings) {}
  std::optional<PoseAnswer> find(std::size_t pulse, const PulseLog& pulses,
                                 const PoseLog& poses) const override;

 private:
  const Settings settings_;
};

/// The same along the line announced for each run. The first pulse is where the robot was measured
/// then, or at the start if it was not measured.
class ToldMotionRule : public PoseRule {
 public:
  explicit ToldMotionRule(const Settings& settings) : settings_(settings), measured_(settings) {}
  void start_run(const std::optional<ConstantSpeed>& motion) override;
  void check_told(std::uint32_t run) const override;
  std::optional<PoseAnswer> find(std::size_t pulse, const PulseLog& pulses,
                                 const PoseLog& poses) const override;

 private:
  const Settings settings_;
  const InterpolationRule measured_;
  std::vector<ConstantSpeed> runs_;
};

/// @return none if the way [m] from the start leads beyond the end
std::optional<Eigen::Isometry3d> pose_along(const ConstantSpeed& motion, double way);

/// A calculated pose.
PoseAnswer calculated(const Eigen::Isometry3d& pose, const Pulse& pulse, double error_bound);
PoseAnswer refuse_beyond_end();

PoseAnswer refuse(DropReason reason, const std::string& detail);
PoseAnswer refuse_gap(double gap, const Settings& settings);

/// Bound on the distance of the true path from the straight line between two measured positions, at
/// `time` between them: a t (T - t) / 2 for an acceleration of at most a (error of linear
/// interpolation).
double line_error(const TimedPose& before, const TimedPose& after, Nanoseconds time,
                  const Settings& settings);

}  // namespace pose_frame_binder
