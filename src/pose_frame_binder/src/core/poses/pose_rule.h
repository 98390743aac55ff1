// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "matching/pulse_log.h"
#include "pose_frame_binder/types.h"
#include "poses/pose_log.h"

namespace pose_frame_binder {

/// The answer of a rule for one pulse: a match, or why there is none.
struct PoseAnswer {
  std::optional<Match> match;
  DropReason reason = DropReason::kPoseGap;
  std::string detail;

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

/// A rule by which a pulse gets its pose (docs/pose_frame_binder.md states the rules).
class PoseRule {
 public:
  virtual ~PoseRule() = default;

  /// Announces the motion of the next run of pulses, accepted by check(), for rules that need it.
  virtual void start_run(const std::optional<ConstantSpeed>&) {}

  /// @param run of a pulse that has arrived
  /// @throw scan_cell_common::Refused if the rule needs the run's motion and it was not announced
  virtual void check_told(std::uint32_t /*run*/) const {}

  /// @param pulse index in the log
  /// @return none while later poses or pulses could change the answer
  virtual std::optional<PoseAnswer> find(std::size_t pulse, const PulseLog& pulses,
                                         const PoseLog& poses) const = 0;
};

/// The rule of the settings' method.
std::unique_ptr<PoseRule> make_pose_rule(const Settings& settings);

}  // namespace pose_frame_binder
