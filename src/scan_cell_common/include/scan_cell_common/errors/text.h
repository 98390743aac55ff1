// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scan_cell_common {

/// The number that the whole text is; none if it is not a number. Independent of the locale.
std::optional<double> parse_number(std::string_view text);

/// The same for a whole number from 0 up.
std::optional<std::uint64_t> parse_count(std::string_view text);

/// The text with ASCII letters in lower case.
std::string lower_case(std::string_view text);

/// The start of a text for an error message: short, and without control characters.
std::string excerpt(std::string_view text);

/// The text without the mark that some editors put before UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

/// Goes through a text line by line, each split into words at its blanks. Lines end with LF or
/// CR LF. The text must outlive it.
class LineReader {
 public:
  /// @param source names the text in errors
  LineReader(std::string_view text, const std::string& source);

  /// Goes to the next line. False at the end.
  bool next();

  /// Goes to the next line that holds more than blanks. False at the end.
  bool next_filled();

  const std::vector<std::string_view>& words() const { return words_; }  //!< of this line

  /// Where the line after this one begins.
  std::size_t position() const { return position_; }

  /// Number of bytes not read yet.
  std::size_t left() const { return text_.size() - position_; }

  /// The text's name and the line's number, for errors.
  std::string where() const;

 private:
  std::string_view text_;
  std::string source_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  std::vector<std::string_view> words_;
};

}  // namespace scan_cell_common
