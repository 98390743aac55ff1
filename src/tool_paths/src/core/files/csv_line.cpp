// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "files/csv_line.h"

#include "scan_cell_common/errors/errors.h"

namespace tool_paths {
namespace {

using scan_cell_common::UnusableInput;

constexpr const char* kBlanks = " \t\r";

bool is_blank(const std::string& text) {
  return text.find_first_not_of(kBlanks) == std::string::npos;
}

}  // namespace

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(kBlanks);
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::vector<std::string> split(const std::string& line, const std::string& where) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  bool was_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[++i];
    } else if (c == '"' && (quoted || is_blank(fields.back()))) {
      if (!quoted) fields.back().clear();
      quoted = !quoted;
      was_quoted = true;
    } else if (c == ',' && !quoted) {
      if (!was_quoted) fields.back() = trimmed(fields.back());
      was_quoted = false;
      fields.emplace_back();
    } else if (!was_quoted || quoted) {
      fields.back() += c;
    } else if (!is_blank({c})) {
      throw UnusableInput(where, "text after a closing quote", "double the quotes within a field");
    }
  }
  if (quoted) throw UnusableInput(where, "a quote is not closed", "close it");
  if (!was_quoted) fields.back() = trimmed(fields.back());
  return fields;
}

std::string quoted_where_needed(const std::string& text) {
  const bool plain = text.find_first_of(",\"\n\r#") == std::string::npos && text == trimmed(text);
  if (plain) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '\n' || c == '\r') {
      result += ' ';
    } else {
      result += c == '"' ? "\"\"" : std::string(1, c);
    }
  }
  return result + "\"";
}

}  // namespace tool_paths
