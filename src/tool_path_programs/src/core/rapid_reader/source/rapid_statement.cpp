// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid_reader/source/rapid_statement.h"

#include <algorithm>
#include <array>

#include "rapid_reader/source/rapid_values.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

bool at_argument_end(const TokenReader& reader) {
  return reader.at_symbol(',') || reader.at_symbol(';') || reader.at_symbol('\\');
}

RapidArgument read_argument(TokenReader& reader) {
  RapidArgument argument;
  argument.begin = reader.position();
  while (!at_argument_end(reader))
    pass_over_brackets(reader);
  argument.end = reader.position();
  return argument;
}

void read_option(TokenReader& reader, RapidCall& call) {
  reader.expect('\\');
  const std::string name = lower_case(reader.name());
  RapidArgument value;
  if (reader.accept(':')) {
    reader.expect('=');
    value = read_argument(reader);
  }
  call.options[name] = value;
}

bool accept_operator(TokenReader& reader) {
  static const std::array<const char*, 6> names = {"AND", "OR", "XOR", "DIV", "MOD", "NOT"};
  static const std::string symbols = "=<>+-*/";
  const bool named = std::any_of(names.begin(), names.end(),
                                 [&](const char* name) { return reader.at_name(name); });
  const bool signs = reader.peek().kind == TokenKind::kSymbol &&
                     symbols.find(reader.peek().text.front()) != std::string::npos;
  if (named || signs) reader.next();
  return named || signs;
}

void pass_over_operand(TokenReader& reader) {
  while (accept_operator(reader)) {
  }
  pass_over_brackets(reader);
  while (reader.at_symbol('.') || reader.at_symbol('{') || reader.at_symbol('(')) {
    const bool part = reader.at_symbol('.');
    pass_over_brackets(reader);
    if (part) reader.name();
  }
}

}  // namespace

RapidCall read_rapid_call(TokenReader& reader) {
  RapidCall call;
  call.place = reader.place();
  call.name = reader.name();
  while (!reader.at_symbol(';')) {
    if (reader.at_symbol('\\'))
      read_option(reader, call);
    else if (!reader.accept(','))
      call.arguments.push_back(read_argument(reader));
  }
  reader.next();
  return call;
}

bool at_rapid_assignment(TokenReader reader) {
  if (reader.peek().kind != TokenKind::kName) return false;
  reader.next();
  while (reader.at_symbol('.') || reader.at_symbol('{')) {
    const bool part = reader.at_symbol('.');
    pass_over_brackets(reader);
    if (part && reader.peek().kind == TokenKind::kName) reader.next();
  }
  return reader.at_symbol(':') && reader.peek_after().text == "=";
}

void pass_over_rapid_expression(TokenReader& reader) {
  do {
    pass_over_operand(reader);
  } while (accept_operator(reader));
}

void pass_over_rapid_statement(TokenReader& reader) {
  while (!reader.at_symbol(';'))
    pass_over_brackets(reader);
  reader.next();
}

}  // namespace tool_path_programs
