// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool_path_programs/program_path.h"

namespace tool_path_programs {

/// A program adapted to another part.
struct AdaptedProgram {
  std::vector<SourceFile> files;   //!< in the order given, the main one first
  std::vector<std::string> notes;  //!< which arcs became lines, and why
};

/// Replaces the poses of a program by those of its adapted path. Nothing else changes, except that
/// an arc that is no circle on the part becomes lines through its adapted places.
/// @param known the settings that the program was read with
/// @param adapted has as many waypoints as program_path.path
/// @param arc_tolerance [m] greatest distance of an arc from its adapted places; beyond it the arc
/// becomes lines
/// @throw scan_cell_common::UnusableInput if the language cannot express a pose or an arc's lines
/// at their place in the text, or the program read back differs
AdaptedProgram adapted_program(const Language& language, const ProgramText& text,
                               const ReadSettings& known, const ProgramPath& program_path,
                               const tool_paths::ToolPath& adapted, double arc_tolerance);

}  // namespace tool_path_programs
