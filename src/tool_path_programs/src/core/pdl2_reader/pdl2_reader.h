// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// As Language::read.
ProgramText read_pdl2(const std::vector<SourceFile>& files, const ReadSettings& settings);

/// As Language::edits.
std::vector<TextEdit> pdl2_edits(const ProgramText& text,
                                 const std::vector<Eigen::Isometry3d>& poses);

/// As Language::lines.
std::vector<TextEdit> pdl2_lines(const ProgramText& text, const std::vector<ArcLines>& arcs);

}  // namespace tool_path_programs
