// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// Loads the files of a program: the main file, files beside it with the same name and another
/// extension of the language (part.dat beside part.src), and others that it calls.
/// @throw scan_cell_common::FileError if a file cannot be read
std::vector<SourceFile> load_program(const Language& language, const std::string& main,
                                     const std::vector<std::string>& others = {});

/// Where save_program() writes the files.
std::vector<std::string> names_of_saved(const std::string& output,
                                        const std::vector<SourceFile>& files);

/// Writes a program's files: the first as `output`, the others beside it under their own names.
/// `output` is written last, so the others exist when it does. Each file is complete or as before.
/// @throw scan_cell_common::FileError if a file cannot be written
void save_program(const std::string& output, const std::vector<SourceFile>& files);

}  // namespace tool_path_programs
