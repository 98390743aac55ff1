// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <vector>

namespace scan_cell_common {

/// Reads a table of comma-separated fields line by line. Empty lines and lines that begin with #
/// are skipped, and blanks around a field removed. Lines end with LF or CR LF. There is no quoting.
class CsvReader {
 public:
  /// @param text must outlive the reader
  /// @param source names the text in errors
  CsvReader(std::string_view text, std::string source);

  /// Goes to the next line. False at the end.
  bool next();

  const std::vector<std::string_view>& fields() const { return fields_; }          //!< of this line
  std::string_view field(std::size_t column) const { return fields_.at(column); }  //!< of this line

  /// Number of the line, from 1.
  std::size_t line() const { return line_; }

  /// @throw UnusableInput if this line has another number of fields
  void expect_fields(std::size_t count) const;

  /// @throw UnusableInput if the field is not a finite number
  double number(std::size_t column) const;

  /// The pose in seven fields from `column` on: x, y, z [m], unit quaternion qx, qy, qz, qw.
  /// @throw UnusableInput if it is not a pose, or looks like millimetres or Euler angles
  Eigen::Isometry3d pose(std::size_t column) const;

  /// @throw UnusableInput about this line
  [[noreturn]] void refuse(const std::string& value, const std::string& cure) const;

 private:
  std::string_view left_;
  std::string source_;
  std::size_t line_ = 0;
  std::vector<std::string_view> fields_;
};

}  // namespace scan_cell_common
