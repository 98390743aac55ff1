// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "krl/krl_files.h"

#include "krl/krl_limits.h"
#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

constexpr std::size_t kFrameLines = 5;  // in every file: &ACCESS, &REL, &PARAM, DEF, END

std::size_t count(const std::vector<Block>& blocks) {
  std::size_t lines = 0;
  for (const Block& block : blocks)
    lines += block.size();
  return lines;
}

void append(std::string& text, const std::vector<std::string>& lines) {
  for (const std::string& line : lines)
    text.append(line).append("\r\n");
}

SourceFile file(const std::string& name, const std::vector<std::string>& head,
                const std::vector<Block>& blocks) {
  SourceFile file{name + ".src", ""};
  append(file.text, {"&ACCESS RVP", "&REL 1", "&PARAM EDITMASK = *", "DEF " + name + " ( )"});
  append(file.text, head);
  for (const Block& block : blocks)
    append(file.text, block);
  append(file.text, {"END"});
  return file;
}

[[noreturn]] void refuse(std::size_t max_lines, const std::string& cure) {
  throw scan_cell_common::InvalidParameter("max_lines", std::to_string(max_lines), cure);
}

void check_fit(const std::vector<Block>& blocks, std::size_t max_lines) {
  for (const Block& block : blocks)
    if (block.size() + kFrameLines > max_lines)
      refuse(max_lines, "a move needs " + std::to_string(block.size() + kFrameLines) + " lines");
}

}  // namespace

std::vector<SourceFile> krl_files(const KrlRoutine& routine, std::size_t max_lines) {
  if (kFrameLines + routine.head.size() + count(routine.blocks) <= max_lines)
    return {file(routine.name, routine.head, routine.blocks)};
  std::vector<SourceFile> parts;
  Block calls;
  check_fit(routine.blocks, max_lines);
  for (const std::vector<Block>& part : filled(routine.blocks, max_lines - kFrameLines)) {
    const std::string name = routine.name + "_" + std::to_string(parts.size() + 1);
    check_krl_name(name);
    parts.push_back(file(name, {}, part));
    calls.push_back(name + "( )");
  }
  if (kFrameLines + routine.head.size() + calls.size() > max_lines)
    refuse(max_lines, "the main file needs " +
                          std::to_string(kFrameLines + routine.head.size() + calls.size()) +
                          " lines; shorten the path");
  parts.insert(parts.begin(), file(routine.name, routine.head, {calls}));
  return parts;
}

}  // namespace tool_path_programs
