// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scan_cell_common {

/// Reads a text table line by line. The first line determines the column separator: semicolons,
/// else tabs, else commas, else blanks. Empty lines are skipped, and blanks and quotes around a
/// field removed. The text must outlive the reader.
class TableReader {
 public:
  TableReader(std::string_view text, const std::string& source);

  /// Goes to the next line that is neither empty nor a comment (#, //, %). False at the end.
  bool next();

  /// Fields of the last comment before the first line: some programs write their header there.
  const std::vector<std::string_view>& comment() const { return comment_; }

  const std::vector<std::string_view>& fields() const { return fields_; }

  /// @throw FileError if this line does not have as many fields as the first
  void expect_columns() const;

  /// The number in a field; NaN if it is empty.
  /// @throw FileError if it is not a number
  double number(std::size_t column) const;

  /// @throw FileError about this line
  [[noreturn]] void refuse(const std::string& value, const std::string& cure) const;

 private:
  void split(std::string_view line, std::vector<std::string_view>& fields) const;

  std::string_view left_;
  std::string source_;
  std::size_t line_ = 0;
  char delimiter_ = '\0';  // '\0': not known yet; ' ': any number of blanks
  std::size_t columns_ = 0;
  std::vector<std::string_view> fields_;
  std::vector<std::string_view> comment_;
};

}  // namespace scan_cell_common
