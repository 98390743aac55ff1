// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "files/table_reader.h"

#include <fmt/format.h>

#include <limits>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace scan_cell_common {
namespace {

constexpr std::string_view kBlank = " \t\r\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

std::string_view unquoted(std::string_view field) {
  const bool quoted = field.size() >= 2 && field.front() == '"' && field.back() == '"';
  return quoted ? trimmed(field.substr(1, field.size() - 2)) : field;
}

char delimiter_of(std::string_view line) {
  for (const char delimiter : {';', '\t', ','}) {
    if (line.find(delimiter) != std::string_view::npos) return delimiter;
  }
  return ' ';
}

/// The text of a comment line; empty if it is not a comment.
std::string_view said_in_comment(std::string_view line) {
  if (line[0] != '#' && line[0] != '%' && line.substr(0, 2) != "//") return {};
  const std::size_t begin = line.find_first_not_of("#%/ \t");
  return begin == std::string_view::npos ? line : line.substr(begin);
}

}  // namespace

TableReader::TableReader(std::string_view text, const std::string& source)
    : left_(without_byte_order_mark(text)), source_(source) {}

bool TableReader::next() {
  while (!left_.empty()) {
    const std::size_t end = left_.find('\n');
    std::string_view line = left_.substr(0, end);
    left_.remove_prefix(end == std::string_view::npos ? left_.size() : end + 1);
    ++line_;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const std::string_view text = trimmed(line);
    if (text.empty()) continue;
    const std::string_view comment = said_in_comment(text);
    if (!comment.empty()) {
      if (delimiter_ != '\0') continue;
      delimiter_ = delimiter_of(comment);
      split(comment, comment_);
      delimiter_ = '\0';
      continue;
    }
    const bool first = delimiter_ == '\0';
    if (first) delimiter_ = delimiter_of(text);
    split(delimiter_ == '\t' ? line : text, fields_);
    if (first) columns_ = fields_.size();
    return true;
  }
  return false;
}

void TableReader::split(std::string_view line, std::vector<std::string_view>& fields) const {
  fields.clear();
  if (delimiter_ != ' ') {
    for (;;) {
      const std::size_t end = line.find(delimiter_);
      fields.push_back(unquoted(trimmed(line.substr(0, end))));
      if (end == std::string_view::npos) return;
      line.remove_prefix(end + 1);
    }
  }
  while (!(line = trimmed(line)).empty()) {
    const std::size_t end = line.find_first_of(kBlank);
    fields.push_back(unquoted(line.substr(0, end)));
    if (end == std::string_view::npos) return;
    line.remove_prefix(end);
  }
}

void TableReader::expect_columns() const {
  if (fields_.size() == columns_) return;
  refuse(fmt::format("{} columns", fields_.size()),
         fmt::format("give {}, as in the first line", columns_));
}

double TableReader::number(std::size_t column) const {
  const std::string_view field = fields_[column];
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  const std::optional<double> value = parse_number(field);
  if (value) return *value;
  const bool decimal_comma = field.find(',') != std::string_view::npos;
  refuse(fmt::format("'{}' in column {}", excerpt(field), column + 1),
         decimal_comma ? "write numbers with a decimal point" : "give a number");
}

void TableReader::refuse(const std::string& value, const std::string& cure) const {
  throw FileError(fmt::format("{}, line {}", source_, line_), value, cure);
}

}  // namespace scan_cell_common
