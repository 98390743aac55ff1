// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "pose_frame_binder/pose_log.h"
#include "pose_frame_binder/pulse_log.h"
#include "pose_frame_binder/types.h"

namespace pose_frame_binder {

/// What a rule says about one pulse: a match, or why there is none.
struct PoseAnswer {
  std::optional<Match> match;
  DropReason reason = DropReason::PoseGap;
  std::string detail;

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

/// The pose of a pulse, by the settings' method (docs/pose_frame_binder.md states both rules).
/// @return none while poses or pulses that still may come could change the answer
std::optional<PoseAnswer> find_pose(std::size_t pulse, const PulseLog& pulses, const PoseLog& poses,
                                    const Settings& settings);

}  // namespace pose_frame_binder
