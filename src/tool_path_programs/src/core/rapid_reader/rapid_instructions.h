// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "tool_path_programs/program.h"

namespace tool_path_programs {

/// An instruction of RAPID that moves the tip to a place that the program says.
struct RapidMotion {
  MotionKind kind = MotionKind::kLinear;
  bool joints = false;       //!< the place is angles of the axes
  std::size_t behind = 0;    //!< how many arguments come behind the tool
  bool sets_output = false;  //!< the two behind the tool are an output and its value
};

/// Null: it is not one of them.
const RapidMotion* rapid_motion(const std::string& name);

/// What says the way along a line that an instruction says along an arc, in the same words behind
/// it; null: there is none.
const char* rapid_line_in_place_of(const std::string& name);

/// Instructions that the reader knows to be without influence on motions.
bool rapid_moves_nothing(const std::string& name);

/// What is wrong with an instruction that decides at run time where the tip is; null: nothing.
const char* rapid_unresolvable(const std::string& name);

}  // namespace tool_path_programs
