// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clouds/carried_fields.h"
#include "clouds/ply/ply_header.h"

namespace scan_cell_common {

/// @throw FileError: the file has only this many of an element
[[noreturn]] void refuse_truncated(const std::string& source, const PlyElement& element,
                                   std::uint64_t read);

/// Refuses a header that promises more than the file can hold, before any memory is allocated.
/// @throw FileError
void check_count(const PlyElement& element, std::size_t min_size, std::size_t left,
                 const std::string& source);

/// The body of an ASCII file. A value is its first word: for a list, its length.
class AsciiPlyBody {
 public:
  using Value = const std::string_view*;
  using Values = std::vector<Value>;

  AsciiPlyBody(LineReader& lines, const std::string& source) : lines_(lines), source_(source) {}

  /// @param take called with the values of each row of the element
  template <class Take>
  void read(const PlyElement& element, const Take& take) {
    check_count(element, 2 * element.properties.size(), lines_.left() + 1, source_);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      if (!lines_.next_filled()) refuse_truncated(source_, element, row);
      split(element);
      take(values_);
    }
  }

  /// @throw FileError
  float number(Value value, const PlyProperty& property) const;

  /// Appends the number to the points' fields.
  /// @throw FileError
  void append(Value value, const PlyProperty& property, FieldedCloud& carried) const;

  /// The whole numbers of a list.
  /// @throw FileError
  void list(Value value, const PlyProperty& property, std::vector<std::uint64_t>& numbers) const;

  /// @throw FileError if more data follows
  void end();

 private:
  double parsed(Value value) const;
  void split(const PlyElement& element);
  [[noreturn]] void refuse_row(const PlyElement& element) const;

  LineReader& lines_;
  const std::string& source_;
  Values values_;
};

/// The body of a binary file. A value is a pointer to its start: for a list, to its length.
class BinaryPlyBody {
 public:
  using Value = const char*;
  using Values = std::vector<Value>;

  BinaryPlyBody(std::string_view bytes, bool big_endian, const std::string& source)
      : bytes_(bytes), big_endian_(big_endian), source_(source) {}

  template <class Take>
  void read(const PlyElement& element, const Take& take) {
    std::size_t min_size = 0;
    for (const PlyProperty& property : element.properties)
      min_size += property.min_size();
    check_count(element, min_size, bytes_.size() - at_, source_);
    Values values(element.properties.size());
    for (std::uint64_t row = 0; row < element.count; ++row) {
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = next(element.properties[i], element, row);
      take(values);
    }
  }

  float number(Value value, const PlyProperty& property) const {
    return load_float(value, property.type, big_endian_);
  }

  void append(Value value, const PlyProperty& property, FieldedCloud& carried) const {
    append_scalar(value, property.type, big_endian_, carried);
  }

  /// @throw FileError
  void list(Value value, const PlyProperty& property, std::vector<std::uint64_t>& numbers) const;

  /// @throw FileError if more data follows
  void end() const;

 private:
  const char* next(const PlyProperty& property, const PlyElement& element, std::uint64_t row);
  const char* advance(std::uint64_t size, const PlyElement& element, std::uint64_t row);
  std::uint64_t whole(const char* value, Scalar type) const;

  std::string_view bytes_;
  std::size_t at_ = 0;
  bool big_endian_;
  const std::string& source_;
};

}  // namespace scan_cell_common
