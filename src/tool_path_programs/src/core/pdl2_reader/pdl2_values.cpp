// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pdl2_reader/pdl2_values.h"

#include <algorithm>
#include <stdexcept>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

constexpr int kLinesOfListing = 8;  // most lines of a pose in a .lsv

bool at_number(const TokenReader& reader) {
  if (reader.peek().kind == TokenKind::kNumber) return true;
  return (reader.at_symbol('-') || reader.at_symbol('+')) &&
         reader.peek_after().kind == TokenKind::kNumber;
}

/// POS(1, 2, 3, 0, 90, 0, ..)
std::optional<Pdl2Pose> read_call(TokenReader& reader) {
  Pdl2Pose pose{{}, reader.peek().offset, reader.place(), ""};
  reader.next();
  if (!reader.accept('(')) return std::nullopt;
  for (std::size_t field = 0; field < 6; ++field) {
    const bool more = field == 0 || reader.accept(',');
    if (!more || !at_number(reader)) return skip_parentheses(reader), std::nullopt;
    pose.numbers[field] = reader.number();
  }
  const bool ends = reader.at_symbol(',') || reader.at_symbol(')');
  if (reader.at_symbol(',') && reader.peek_after().kind == TokenKind::kText)
    pose.configuration = reader.peek_after().text;
  skip_parentheses(reader);
  if (!ends) return std::nullopt;
  return pose;
}

/// X:1 Y:2 Z:3 A:0 E:90 R:0
std::optional<Pdl2Pose> read_list(TokenReader& reader) {
  Pdl2Pose pose{{}, reader.peek().offset, reader.place(), ""};
  std::size_t field = 0;
  for (const char* name : {"X", "Y", "Z", "A", "E", "R"}) {
    while (reader.peek().kind == TokenKind::kLineEnd)
      reader.next();
    if (!reader.accept(name) || !reader.accept(':') || !at_number(reader)) return std::nullopt;
    pose.numbers[field++] = reader.number();
  }
  if (reader.at_name("cnfg") && reader.peek_after().text == ":") {
    reader.next();
    reader.next();
    if (reader.peek().kind == TokenKind::kText) pose.configuration = reader.next().text;
  }
  return pose;
}

/// {10, -20, 30}
std::optional<std::vector<double>> read_joints(TokenReader& reader) {
  std::vector<double> joints;
  reader.expect('{');
  while (at_number(reader)) {
    joints.push_back(reader.number().value);
    if (!reader.accept(',')) break;
  }
  const bool whole = reader.accept('}');
  while (!whole && !reader.at_line_end() && !reader.accept('}'))
    reader.next();
  if (!whole) return std::nullopt;
  return joints;
}

}  // namespace

const LexicalRules& pdl2_rules() {
  static const LexicalRules rules{{"--"}, "'", "$"};
  return rules;
}

Pdl2Numbers Pdl2Pose::values() const {
  Pdl2Numbers values;
  for (std::size_t field = 0; field < values.size(); ++field)
    values[field] = numbers[field].value;
  return values;
}

bool at_statement_end(const TokenReader& reader) {
  return reader.at_line_end() || reader.at_symbol(';');
}

void skip_parentheses(TokenReader& reader) {
  for (std::size_t depth = 1; depth > 0 && !reader.at_line_end();) {
    if (reader.at_symbol('(')) ++depth;
    if (reader.at_symbol(')')) --depth;
    reader.next();
  }
}

std::optional<Pdl2Pose> read_pos(TokenReader& reader) {
  return reader.at_name("pos") ? read_call(reader) : read_list(reader);
}

Pdl2Pose pdl2_pose_at(const SourceFile& file, std::size_t offset) {
  std::size_t end = offset;
  for (int line = 0; line < kLinesOfListing && end < file.text.size(); ++line)
    end = std::min(file.text.find('\n', end), file.text.size() - 1) + 1;
  const SourceFile piece{file.name, file.text.substr(offset, end - offset)};
  const auto tokens = tokens_of(piece, pdl2_rules());
  TokenReader reader(piece, 0, tokens);
  const auto pose = read_pos(reader);
  if (!pose) throw std::logic_error("a pose that is none any more");
  return *pose;
}

Pdl2Value read_pdl2_value(TokenReader& reader) {
  Pdl2Value value;
  value.place = reader.place();
  if (reader.at_name("pos")) {
    value.pose = read_pos(reader);
  } else if (reader.at_name("xtndpos")) {
    reader.next();
    if (reader.accept('(') && reader.at_name("pos")) value.pose = read_pos(reader);
    skip_parentheses(reader);
  } else if (reader.at_symbol('{')) {
    value.joints = read_joints(reader);
  } else if (at_number(reader)) {
    value.number = reader.number().value;
  }
  return value;
}

std::string read_pdl2_variable(TokenReader& reader) {
  std::string name = scan_cell_common::lower_case(reader.name());
  if (!reader.accept('[')) return name;
  const bool known = reader.peek().kind == TokenKind::kNumber;
  if (known) name += "[" + shortest(reader.next().number, 3) + "]";
  if (reader.accept(']')) return known ? name : "";
  while (!reader.at_line_end() && !reader.accept(']'))
    reader.next();
  return "";
}

}  // namespace tool_path_programs
