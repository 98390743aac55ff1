// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// How far what is read back may be from what was meant.
struct ReadBackLimits {
  double position = 1e-6;             //!< [m]
  double angle = 1.7453292519943e-5;  //!< [rad] 0.001 degree
  double speed = 0.01;                //!< share, of every speed
  double zone = 1e-6;                 //!< [m]
};

/// The first difference between a program and what was read of its text, with the waypoint: kinds,
/// poses, speeds, zones and outputs, in their order. Empty: there is none.
/// @param unsaid is not compared
std::string first_difference(const Program& meant, const Program& read, const Unsaid& unsaid,
                             const ReadBackLimits& limits = {});

/// Writes a program and reads it back before anybody gets it.
/// @param known what the reader cannot know from the files
/// @throw scan_cell_common::UnusableInput if the language cannot say it, or if what is read back is
/// another program
WrittenProgram write_checked(const Language& language, const Program& program,
                             const WriteSettings& settings, const ReadSettings& known = {});

}  // namespace tool_path_programs
