// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fanuc_reader/fanuc_source.h"

namespace tool_path_programs {

/// Whether a line without meaning for the controller begins here: "!", "//" or "--".
bool is_fanuc_remark(const TokenReader& reader);

/// What the statement that begins here is. Goes nowhere.
FanucStatement fanuc_statement(TokenReader reader);

/// What a statement says of other statements: jumps to labels, calls.
struct FanucBranches {
  std::vector<int> labels;
  std::vector<std::string> calls;
  bool computed = false;  //!< a label or program that only a running program knows
};

/// @param end of the statement, among the tokens
FanucBranches fanuc_branches(TokenReader reader, std::size_t end);

}  // namespace tool_path_programs
