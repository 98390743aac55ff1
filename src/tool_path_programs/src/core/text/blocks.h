// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tool_path_programs {

/// Lines that must stay together in one file: a move and what belongs to it.
using Block = std::vector<std::string>;

/// Distributes blocks over files, in order.
/// @param lines of a file available to blocks; no block is longer
std::vector<std::vector<Block>> filled(const std::vector<Block>& blocks, std::size_t lines);

/// Splits a comment into lines: at its own line ends, and where a line is longer than `width`.
std::vector<std::string> comment_lines(const std::string& comment, std::size_t width);

}  // namespace tool_path_programs
