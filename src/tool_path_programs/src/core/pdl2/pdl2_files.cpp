// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pdl2/pdl2_files.h"

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

constexpr std::size_t kLongestName = 32;
constexpr std::size_t kPartLines = 8;  // of a program for a part, besides its moves

using Lines = std::vector<std::string>;

bool is_letter(char character) {
  return (character >= 'A' && character <= 'Z') || (character >= 'a' && character <= 'z');
}

bool is_name_character(char character) {
  return is_letter(character) || (character >= '0' && character <= '9') || character == '_';
}

void append(Lines& lines, const Lines& more, const std::string& indent = "") {
  for (const std::string& line : more)
    lines.push_back(indent + line);
}

void append(Lines& lines, const std::vector<Block>& blocks) {
  for (const Block& block : blocks)
    append(lines, block, "  ");
}

SourceFile file(const std::string& name, const Lines& lines) {
  SourceFile file{name + ".pdl", ""};
  for (const std::string& line : lines)
    file.text.append(line).append("\r\n");
  return file;
}

std::string exported(const std::string& program) {
  return "ROUTINE R_" + program + " EXPORTED FROM " + program;
}

Lines main_of(const Pdl2Routine& routine, const Lines& declared, const std::vector<Block>& blocks) {
  Lines lines = {"PROGRAM " + routine.name};
  append(lines, routine.comments);
  if (!routine.variables.empty()) lines.emplace_back("VAR");
  append(lines, routine.variables, "  ");
  append(lines, declared);
  lines.emplace_back("BEGIN");
  append(lines, routine.head, "  ");
  append(lines, blocks);
  lines.push_back("END " + routine.name);
  return lines;
}

Lines part_of(const std::string& name, const std::vector<Block>& blocks, const Lines& variables) {
  Lines lines = {"PROGRAM " + name};
  if (!variables.empty()) lines.emplace_back("VAR");
  append(lines, variables, "  ");
  append(lines, {exported(name), "ROUTINE R_" + name, "BEGIN"});
  append(lines, blocks);
  append(lines, {"END R_" + name, "BEGIN", "END " + name});
  return lines;
}

[[noreturn]] void refuse(std::size_t max_lines, std::size_t needed) {
  throw scan_cell_common::InvalidParameter(
      "max_lines", std::to_string(max_lines),
      "give at least " + std::to_string(needed) + ", or a shorter path");
}

/// @param beside lines of a file that are not blocks
void check_fit(const std::vector<Block>& blocks, std::size_t beside, std::size_t max_lines) {
  for (const Block& block : blocks)
    if (block.size() + beside > max_lines) refuse(max_lines, block.size() + beside);
}

}  // namespace

void check_pdl2_name(const std::string& thing, const std::string& name) {
  std::string good;
  for (const char character : name)
    good += is_name_character(character) ? character : '_';
  if (good.empty() || !is_letter(good.front())) good.insert(0, "P");
  good = good.substr(0, kLongestName);
  if (name == good) return;
  throw scan_cell_common::UnusableInput(
      thing, scan_cell_common::excerpt(name),
      "PDL2 takes letters, digits and _, at most 32 of them: " + good);
}

std::vector<SourceFile> pdl2_files(const Pdl2Routine& routine, std::size_t max_lines) {
  const Lines whole = main_of(routine, {}, routine.blocks);
  if (whole.size() <= max_lines) return {file(routine.name, whole)};
  std::vector<SourceFile> parts;
  Lines declared;
  Block calls;
  const std::size_t beside = kPartLines + routine.variables.size();
  check_fit(routine.blocks, beside, max_lines);
  for (const std::vector<Block>& part : filled(routine.blocks, max_lines - beside)) {
    const std::string name = routine.name + "_" + std::to_string(parts.size() + 1);
    check_pdl2_name("program name", "R_" + name);
    parts.push_back(file(name, part_of(name, part, routine.variables)));
    declared.push_back(exported(name));
    calls.push_back("R_" + name);
  }
  const Lines main = main_of(routine, declared, {calls});
  if (main.size() > max_lines) refuse(max_lines, main.size());
  parts.insert(parts.begin(), file(routine.name, main));
  return parts;
}

}  // namespace tool_path_programs
