// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid/rapid_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

bool is_letter(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z');
}

bool is_of_names(char character) {
  return is_letter(character) || character == '_' || (character >= '0' && character <= '9');
}

bool is_reserved(const std::string& name) {
  static const std::set<std::string> words = {
      "alias",     "and",     "backward", "case",     "connect",   "const", "default",   "div",
      "do",        "else",    "elseif",   "endfor",   "endfunc",   "endif", "endmodule", "endproc",
      "endrecord", "endtest", "endtrap",  "endwhile", "error",     "exit",  "false",     "for",
      "from",      "func",    "goto",     "if",       "inout",     "local", "mod",       "module",
      "nostepin",  "not",     "noview",   "or",       "pers",      "proc",  "raise",     "readonly",
      "record",    "retry",   "return",   "step",     "sysmodule", "task",  "test",      "then",
      "to",        "trap",    "true",     "trynext",  "undo",      "var",   "viewonly",  "while",
      "with",      "xor"};
  return words.count(scan_cell_common::lower_case(name)) != 0;
}

std::string name_that_would_do(const std::string& name, std::size_t longest) {
  std::string better;
  for (const char character : name)
    better += is_of_names(character) ? character : '_';
  if (better.empty() || !is_letter(better.front()) || is_reserved(better)) better = "p_" + better;
  return better.substr(0, longest);
}

}  // namespace

void check_rapid_name(const std::string& thing, const std::string& name, std::size_t longest) {
  std::string fault;
  if (name.empty())
    fault = "no name";
  else if (!is_letter(name.front()) || !std::all_of(name.begin(), name.end(), is_of_names))
    fault = "RAPID names begin with a letter and have only ASCII letters, digits and _";
  else if (is_reserved(name))
    fault = "a word of RAPID itself";
  else if (name.size() > longest)
    fault = fmt::format("{} characters of at most {}", name.size(), longest);
  if (!fault.empty())
    throw scan_cell_common::UnusableInput(
        thing + " '" + scan_cell_common::excerpt(name) + "'", fault,
        "name it " + name_that_would_do(name, longest) + ", for example");
}

}  // namespace tool_path_programs
