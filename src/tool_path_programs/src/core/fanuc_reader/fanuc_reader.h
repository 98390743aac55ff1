// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// @throw scan_cell_common::UnusableInput naming file and line of what cannot be resolved
ProgramText read_fanuc(const std::vector<SourceFile>& files, const ReadSettings& settings);

/// As Language::edits.
std::vector<TextEdit> fanuc_edits(const ProgramText& text,
                                  const std::vector<Eigen::Isometry3d>& poses);

/// As Language::lines.
std::vector<TextEdit> fanuc_lines(const ProgramText& text, const std::vector<ArcLines>& arcs);

}  // namespace tool_path_programs
