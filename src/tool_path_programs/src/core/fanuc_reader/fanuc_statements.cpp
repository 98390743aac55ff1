// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fanuc_reader/fanuc_statements.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using Kind = FanucStatementKind;
using scan_cell_common::lower_case;

template <std::size_t N>
bool is_one_of(const std::string& name, const std::array<const char*, N>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// IF .. THEN opens a block; IF .. ,JMP does not.
bool ends_with_then(TokenReader reader) {
  while (!reader.at_end() && !reader.at_symbol(';')) {
    if (reader.at_name("THEN")) return true;
    reader.next();
  }
  return false;
}

bool has_branch(TokenReader reader) {
  while (!reader.at_line_end() && !reader.at_symbol(';')) {
    if (reader.at_name("JMP") || reader.at_name("LBL") || reader.at_name("CALL")) return true;
    reader.next();
  }
  return false;
}

bool at_motion(const TokenReader& reader) {
  static const std::array<const char*, 5> letters = {"j", "l", "c", "a", "s"};
  const std::string target = lower_case(reader.peek_after().text);
  return is_one_of(lower_case(reader.peek().text), letters) && (target == "p" || target == "pr");
}

Kind kind_of(const TokenReader& reader, const std::string& name) {
  static const std::array<const char*, 4> frames = {"uframe_num", "utool_num", "uframe", "utool"};
  static const std::array<const char*, 3> ends = {"endif", "endfor", "else"};
  if (at_motion(reader)) return Kind::kMotion;
  if (is_one_of(name, frames)) return Kind::kFrame;
  if ((name == "do" || name == "ro") && reader.peek_after().text == "[") return Kind::kOutput;
  if (name == "call") return Kind::kCall;
  if (name == "for" || (name == "if" && ends_with_then(reader))) return Kind::kBegin;
  if (name == "else" && reader.peek_after().text == ",") return Kind::kBranch;
  if (name == "else") return Kind::kOther;
  if (is_one_of(name, ends)) return Kind::kEnd;
  if (name == "lbl") return Kind::kLabel;
  if (name == "end" || name == "abort") return Kind::kStop;
  if (name == "p" && reader.peek_after().text == "[") return Kind::kChanged;
  return has_branch(reader) ? Kind::kBranch : Kind::kOther;
}

}  // namespace

bool is_fanuc_remark(const TokenReader& reader) {
  const std::string_view next = reader.peek_after().text;
  return reader.at_symbol('!') || (reader.at_symbol('/') && next == "/") ||
         (reader.at_symbol('-') && next == "-");
}

FanucStatement fanuc_statement(TokenReader reader) {
  FanucStatement statement;
  if (is_fanuc_remark(reader)) return statement;
  statement.kind = kind_of(reader, lower_case(reader.peek().text));
  if (statement.kind == Kind::kLabel) {
    reader.next();
    const auto label = read_fanuc_index(reader);
    if (!label) reader.fail("a label without a number", "correct the program");
    statement.label = *label;
  }
  return statement;
}

FanucBranches fanuc_branches(TokenReader reader, std::size_t end) {
  FanucBranches branches;
  while (reader.position() < end) {
    if (reader.accept("LBL")) {
      const auto label = read_fanuc_index(reader);
      if (label) branches.labels.push_back(*label);
      branches.computed = branches.computed || !label;
    } else if (reader.accept("CALL") || reader.accept("RUN")) {
      if (reader.peek().kind != TokenKind::kName || reader.peek_after().text == "[")
        branches.computed = true;
      else
        branches.calls.emplace_back(reader.name());
    } else {
      reader.next();
    }
  }
  return branches;
}

}  // namespace tool_path_programs
