// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tool_path_programs {

/// Lines that stay in one file: a move, and what must stand beside it.
using Block = std::vector<std::string>;

/// Blocks that fill files one after the other.
/// @param lines of a file that blocks may take; none of them has more
std::vector<std::vector<Block>> filled(const std::vector<Block>& blocks, std::size_t lines);

/// A comment as lines: it ends where its own lines end, and goes on in the next one where it is
/// longer than `width`.
std::vector<std::string> comment_lines(const std::string& comment, std::size_t width);

}  // namespace tool_path_programs
