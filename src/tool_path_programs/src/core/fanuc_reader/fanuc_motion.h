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
  std::optional<int> via;  //!< index of P[], of circular motions
  ArcText arc;             //!< of circular motions
  int target = 0;          //!< index of P[]
  double speed = 0;        //!< [m/s]; of joint motions: share of the axes' speed
  double zone = 0;         //!< [m] CNT is no length: any above 0 is read as kFanucUnknownZone
};

/// [m] zone read for CNT: its length depends on speeds and accelerations.
constexpr double kFanucUnknownZone = 0.001;

/// @param end of the statement, among the tokens
/// @throw scan_cell_common::UnusableInput naming file and line of a value known only at run time
FanucMotion read_fanuc_motion(TokenReader& reader, std::size_t end);

}  // namespace tool_path_programs
