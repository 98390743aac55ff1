// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "fanuc_reader/fanuc_source.h"
#include "tool_path_programs/program.h"

namespace tool_path_programs {

/// A motion statement, before its positions are looked up.
struct FanucMotion {
  MotionKind kind = MotionKind::kLinear;
  std::optional<int> via;  //!< which P[], of circular motions
  ArcText arc;             //!< of circular motions
  int target = 0;          //!< which P[]
  double speed = 0;        //!< [m/s], of joint motions share of the axes' own
  double zone = 0;         //!< [m] CNT is no length: any above 0 is read as kFanucUnknownZone
};

/// What stands for CNT, whose distance from the pose depends on speeds and accelerations [m].
constexpr double kFanucUnknownZone = 0.001;

/// @param end of the statement, among the tokens
/// @throw scan_cell_common::UnusableInput naming file and line of what only a running program knows
FanucMotion read_fanuc_motion(TokenReader& reader, std::size_t end);

}  // namespace tool_path_programs
