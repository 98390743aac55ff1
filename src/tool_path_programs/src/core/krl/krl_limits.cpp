// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "krl/krl_limits.h"

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

constexpr std::size_t kLongestName = 24;
constexpr std::uint64_t kFrames = 128;
constexpr std::uint64_t kOutputs = 8192;

bool is_letter(char character) {
  return (character >= 'A' && character <= 'Z') || (character >= 'a' && character <= 'z') ||
         character == '_';
}

bool is_name_character(char character) {
  return is_letter(character) || (character >= '0' && character <= '9');
}

std::string name_that_would_do(const std::string& name) {
  std::string good;
  for (const char character : name)
    good += is_name_character(character) ? character : '_';
  if (good.empty() || !is_letter(good.front())) good.insert(0, "P");
  return good.substr(0, kLongestName);
}

}  // namespace

std::size_t krl_lines_of(const std::string& dialect) {
  if (dialect.empty() || dialect == "krc4") return 1400;
  if (dialect == "krc2") return 2500;
  throw scan_cell_common::InvalidParameter("dialect", dialect, "give krc4 or krc2");
}

void check_krl_name(const std::string& name) {
  const std::string good = name_that_would_do(name);
  if (name == good) return;
  throw UnusableInput("program name", scan_cell_common::excerpt(name),
                      "KRL takes letters, digits and _, at most 24 of them: " + good);
}

int krl_frame_number(const std::string& name, const std::string& array) {
  std::string_view number = name;
  const std::string begin = scan_cell_common::lower_case(array) + "[";
  if (scan_cell_common::lower_case(name).rfind(begin, 0) == 0 && name.back() == ']')
    number = number.substr(begin.size(), name.size() - begin.size() - 1);
  const auto value = scan_cell_common::parse_count(number);
  if (!value || *value > kFrames)
    throw UnusableInput(array, scan_cell_common::excerpt(name),
                        "give its number on the controller, 0 to 128");
  return static_cast<int>(*value);
}

int krl_output_number(const std::string& output) {
  const auto number = scan_cell_common::parse_count(output);
  if (!number || *number == 0 || *number > kOutputs)
    throw UnusableInput("output", scan_cell_common::excerpt(output),
                        "KRL knows outputs by number: give one from 1 to 8192");
  return static_cast<int>(*number);
}

}  // namespace tool_path_programs
