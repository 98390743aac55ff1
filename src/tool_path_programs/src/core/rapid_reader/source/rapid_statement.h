// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "text/token_reader.h"

namespace tool_path_programs {

/// An argument of a call, as a range of tokens.
struct RapidArgument {
  std::size_t begin = 0;
  std::size_t end = 0;  //!< one past its last token
};

/// The call of an instruction or a routine.
struct RapidCall {
  std::string name;  //!< as written
  Place place;
  std::vector<RapidArgument> arguments;
  std::map<std::string, RapidArgument> options;  //!< \WObj:=.., by name in lower case
};

/// Reads from the routine's name past its semicolon.
RapidCall read_rapid_call(TokenReader& reader);

/// Whether an assignment begins here: name := .., name.part := .., name{..} := ..
bool at_rapid_assignment(TokenReader reader);

/// Skips one expression: the condition of an IF without THEN has no end mark.
void pass_over_rapid_expression(TokenReader& reader);

/// Goes past the next semicolon.
void pass_over_rapid_statement(TokenReader& reader);

}  // namespace tool_path_programs
