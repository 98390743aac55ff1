// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "text/token_reader.h"

namespace tool_path_programs {

/// An argument of a call, as places among the tokens.
struct RapidArgument {
  std::size_t begin = 0;
  std::size_t end = 0;  //!< behind its last token
};

/// The call of an instruction or a routine.
struct RapidCall {
  std::string name;  //!< as written
  Place place;
  std::vector<RapidArgument> arguments;
  std::map<std::string, RapidArgument> options;  //!< \WObj:=.., by names in lower case
};

/// From the routine's name to behind its semicolon.
RapidCall read_rapid_call(TokenReader& reader);

/// Whether an assignment begins here: name := .., name.part := .., name{..} := ..
bool at_rapid_assignment(TokenReader reader);

/// Over one expression: IF's condition has no mark at its end where no THEN follows.
void pass_over_rapid_expression(TokenReader& reader);

/// Behind the next semicolon.
void pass_over_rapid_statement(TokenReader& reader);

}  // namespace tool_path_programs
