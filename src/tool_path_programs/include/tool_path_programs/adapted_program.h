// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool_path_programs/program_path.h"

namespace tool_path_programs {

/// A program on another part.
struct AdaptedProgram {
  std::vector<SourceFile> files;   //!< as they were given, the main one first
  std::vector<std::string> notes;  //!< which arcs became lines, and why
};

/// The program with the poses of its adapted path. Nothing else changes, but that an arc which is
/// no circle on the part becomes lines through the adapted places on it.
/// @param known as the program was read with
/// @param adapted as many waypoints as program_path.path
/// @param arc_tolerance [m] that an arc may be off its adapted places and stay an arc
/// @throw scan_cell_common::UnusableInput if the language cannot say a pose or an arc's lines where
/// they stand, or what is read back differs
AdaptedProgram adapted_program(const Language& language, const ProgramText& text,
                               const ReadSettings& known, const ProgramPath& program_path,
                               const tool_paths::ToolPath& adapted, double arc_tolerance);

}  // namespace tool_path_programs
