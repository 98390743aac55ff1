// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fanuc_reader/fanuc_source.h"

#include <algorithm>
#include <cmath>

#include "fanuc_reader/fanuc_statements.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

bool at_section(const TokenReader& reader, const char* name) {
  return reader.at_symbol('/') && lower_case(reader.peek_after().text) == name;
}

/// Goes past the line that begins a section.
void go_to_section(TokenReader& reader, const char* name) {
  while (!reader.at_end() && !at_section(reader, name))
    reader.skip_line();
  if (reader.at_end())
    reader.fail(std::string("no /") + name + " in this file", "give a program as text, an LS file");
  reader.skip_line();
}

/// Skips "12:" or ":" at the beginning of a line.
void pass_over_line_number(TokenReader& reader) {
  if (reader.peek().kind == TokenKind::kNumber && reader.peek_after().text == ":") reader.next();
  reader.accept(':');
}

void pass_over_line_ends(TokenReader& reader) {
  while (!reader.at_end() && reader.at_line_end())
    reader.next();
}

std::optional<int> read_frame_number(TokenReader& reader) {
  reader.expect(':');
  if (reader.peek().kind != TokenKind::kNumber) {
    reader.name();
    return std::nullopt;
  }
  return static_cast<int>(reader.number().value);
}

/// none: asterisks, for a number that was never taught.
std::optional<NumberText> read_value(TokenReader& reader) {
  reader.expect('=');
  if (!reader.at_symbol('*')) return reader.number();
  while (reader.accept('*')) {
  }
  return std::nullopt;
}

void read_field(TokenReader& reader, FanucPosition& position) {
  static const std::string letters = "XYZWPR";
  const std::string name(reader.next().text);
  if (name == "UF") {
    position.user_frame = read_frame_number(reader);
  } else if (name == "UT") {
    position.tool = read_frame_number(reader);
  } else if (name.size() == 1 && letters.find(name) != std::string::npos && reader.at_symbol('=')) {
    position.pose[letters.find(name)] = read_value(reader);
  } else if (name.size() == 2 && name.front() == 'J' && reader.at_symbol('=')) {
    const auto angle = read_value(reader);
    position.joints.push_back(angle ? angle->value : NAN);
  }
}

}  // namespace

std::vector<Token> fanuc_tokens(const SourceFile& file) {
  return tokens_of(file, {{}, "", "$"});
}

std::optional<int> read_fanuc_index(TokenReader& reader) {
  reader.expect('[');
  std::optional<int> index;
  const double number = reader.peek().number;
  if (reader.peek().kind == TokenKind::kNumber && number >= 0 && number < 1e6 &&
      number == std::floor(number))
    index = static_cast<int>(reader.next().number);
  if (!reader.at_symbol(']') && !reader.at_symbol(':')) index = std::nullopt;
  int depth = 1;
  while (depth > 0) {
    if (reader.at_line_end()) reader.fail("the line ends within brackets", "close them");
    depth += reader.at_symbol('[') ? 1 : reader.at_symbol(']') ? -1 : 0;
    reader.next();
  }
  return index;
}

FanucPosition read_fanuc_position(TokenReader& reader) {
  FanucPosition position;
  position.offset = reader.peek().offset;
  position.line = reader.place().line;
  while (!reader.at_end() && !reader.at_symbol('{'))
    reader.next();
  reader.expect('{');
  bool first_group = true;
  while (!reader.accept('}')) {
    if (reader.at_end()) reader.fail("the file ends within a position", "give all of it");
    if (reader.peek().kind == TokenKind::kName && lower_case(reader.peek().text) == "gp2")
      first_group = false;
    if (first_group && reader.peek().kind == TokenKind::kName)
      read_field(reader, position);
    else
      reader.next();
  }
  reader.accept(';');
  return position;
}

FanucSource::FanucSource(const std::vector<SourceFile>& files) : files_(files) {
  tokens_.reserve(files.size());
  for (std::size_t file = 0; file < files.size(); ++file) {
    tokens_.push_back(fanuc_tokens(files[file]));
    read(file);
  }
}

TokenReader FanucSource::reader(std::size_t file, std::size_t position) const {
  TokenReader reader(files_[file], file, tokens_[file]);
  reader.go_to(position);
  return reader;
}

const FanucProgram* FanucSource::program(const std::string& name) const {
  for (const FanucProgram& program : programs_)
    if (lower_case(program.name) == lower_case(name)) return &program;
  return nullptr;
}

void FanucSource::read(std::size_t file) {
  TokenReader reader = this->reader(file, 0);
  while (!reader.at_end() && !at_section(reader, "prog"))
    reader.next();
  reader.expect('/');
  reader.expect("prog");
  const std::string name = reader.name();
  if (program(name)) reader.fail(name + " appears twice", "give each program once");
  FanucProgram& program = programs_.emplace_back();
  program.name = name;
  program.file = file;
  go_to_section(reader, "mn");
  read_statements(reader, program);
  read_positions(reader, program);
}

void FanucSource::read_statements(TokenReader& reader, FanucProgram& program) {
  while (!at_section(reader, "pos") && !at_section(reader, "end")) {
    if (reader.at_end()) reader.fail("the file ends within /MN", "give all of it");
    pass_over_line_number(reader);
    if (reader.at_line_end() || reader.accept(';')) {
      reader.skip_line();
      continue;
    }
    FanucStatement statement = fanuc_statement(reader);
    statement.begin = reader.position();
    const bool remark = is_fanuc_remark(reader);
    while (!reader.at_end() && !reader.at_symbol(';') && !(remark && reader.at_line_end())) {
      const bool line_ends = reader.at_line_end();
      reader.next();
      if (!line_ends) continue;
      if (at_section(reader, "pos") || at_section(reader, "end"))
        reader.fail("/MN ends within a statement", "give all of it");
      if (reader.peek().kind == TokenKind::kNumber && reader.peek_after().text == ":")
        reader.fail("a statement before it has no semicolon", "correct the program");
      pass_over_line_number(reader);
    }
    statement.end = reader.position();
    program.statements.push_back(statement);
    reader.skip_line();
  }
}

void FanucSource::read_positions(TokenReader& reader, FanucProgram& program) {
  if (!at_section(reader, "pos")) return;
  reader.skip_line();
  while (!at_section(reader, "end")) {
    pass_over_line_ends(reader);
    if (at_section(reader, "end")) break;
    if (!reader.at_name("P")) reader.fail("no position", "expected a position P[..]{");
    TokenReader number = reader;
    number.next();
    const auto index = read_fanuc_index(number);
    const FanucPosition position = read_fanuc_position(reader);
    if (!index || !program.positions.emplace(*index, position).second)
      number.fail("a position without its own number", "correct the program");
    pass_over_line_ends(reader);
    if (reader.at_end()) reader.fail("no /END", "give all of the file");
  }
}

}  // namespace tool_path_programs
