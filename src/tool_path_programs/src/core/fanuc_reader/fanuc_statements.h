// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fanuc_reader/fanuc_source.h"

namespace tool_path_programs {

/// Whether a line that the controller ignores begins here: "!", "//" or "--".
bool is_fanuc_remark(const TokenReader& reader);

/// The kind of the statement that begins here. The reader does not move.
FanucStatement fanuc_statement(TokenReader reader);

/// Other statements that a statement refers to: jumps to labels, calls.
struct FanucBranches {
  std::vector<int> labels;
  std::vector<std::string> calls;
  bool computed = false;  //!< a label or program is known only at run time
};

/// @param end of the statement, among the tokens
FanucBranches fanuc_branches(TokenReader reader, std::size_t end);

}  // namespace tool_path_programs
