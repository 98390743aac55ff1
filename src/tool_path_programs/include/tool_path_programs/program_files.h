// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// The files of a program: the main one, those of the same name with another ending of the
/// language where they are there (part.dat beside part.src), and others that it calls.
/// @throw scan_cell_common::FileError if one cannot be read
std::vector<SourceFile> load_program(const Language& language, const std::string& main,
                                     const std::vector<std::string>& others = {});

/// Where save_program() writes them.
std::vector<std::string> names_of_saved(const std::string& output,
                                        const std::vector<SourceFile>& files);

/// Writes a program's files: the first as `output`, the others beside it under their own names and
/// before it, so that where it is they are. Each file is whole or as it was before.
/// @throw scan_cell_common::FileError if one cannot be written
void save_program(const std::string& output, const std::vector<SourceFile>& files);

}  // namespace tool_path_programs
