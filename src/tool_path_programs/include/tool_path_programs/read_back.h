// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// How far a program read back may differ from the one written.
struct ReadBackLimits {
  double position = 1e-6;             //!< [m]
  double angle = 1.7453292519943e-5;  //!< [rad] 0.001 degree
  double speed = 0.01;                //!< relative, of every speed
  double zone = 1e-6;                 //!< [m]
};

/// The first difference between a program and what was read from its text, with the waypoint.
/// Kinds, poses, speeds, zones and outputs are compared in order. Empty: no difference.
/// @param unsaid what is not compared
std::string first_difference(const Program& meant, const Program& read, const Unsaid& unsaid,
                             const ReadBackLimits& limits = {});

/// Writes a program and reads it back to check it.
/// @param known facts that the reader cannot find in the files
/// @throw scan_cell_common::UnusableInput if the language cannot express the program, or the
/// program read back differs
WrittenProgram write_checked(const Language& language, const Program& program,
                             const WriteSettings& settings, const ReadSettings& known = {});

}  // namespace tool_path_programs
