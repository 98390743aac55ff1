// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "tool_path_programs/program.h"

namespace tool_path_programs {

/// A RAPID instruction that moves the tip to a place given in the program.
struct RapidMotion {
  MotionKind kind = MotionKind::kLinear;
  bool joints = false;       //!< the target is joint angles
  std::size_t behind = 0;    //!< number of arguments after the tool
  bool sets_output = false;  //!< the two arguments after the tool are an output and its value
};

/// null: not such an instruction.
const RapidMotion* rapid_motion(const std::string& name);

/// The line instruction that takes the place of an arc instruction, with the same arguments after
/// the target; null: none.
const char* rapid_line_in_place_of(const std::string& name);

/// Whether the instruction is known not to influence motions.
bool rapid_moves_nothing(const std::string& name);

/// What is wrong with an instruction whose target is known only at run time; null: nothing.
const char* rapid_unresolvable(const std::string& name);

}  // namespace tool_path_programs
