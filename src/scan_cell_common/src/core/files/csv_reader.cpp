// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/files/csv_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/pose/unit_quaternion.h"

namespace scan_cell_common {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr const char* kBlank = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlank);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlank) - begin + 1);
}

}  // namespace

CsvReader::CsvReader(std::string_view text, std::string source)
    : left_(without_byte_order_mark(text)), source_(std::move(source)) {}

bool CsvReader::next() {
  while (!left_.empty()) {
    const std::size_t end = left_.find('\n');
    std::string_view text = trimmed(left_.substr(0, end));
    left_.remove_prefix(end == std::string_view::npos ? left_.size() : end + 1);
    ++line_;
    if (text.empty() || text.front() == '#') continue;
    fields_.clear();
    for (;;) {
      const std::size_t comma = text.find(',');
      fields_.push_back(trimmed(text.substr(0, comma)));
      if (comma == std::string_view::npos) return true;
      text.remove_prefix(comma + 1);
    }
  }
  return false;
}

void CsvReader::expect_fields(std::size_t count) const {
  if (fields_.size() == count) return;
  refuse(fmt::format("{} values", fields_.size()), fmt::format("give {}, as in the header", count));
}

double CsvReader::number(std::size_t column) const {
  const auto value = parse_number(field(column));
  if (!value || !std::isfinite(*value)) refuse("'" + excerpt(field(column)) + "'", "give a number");
  return *value;
}

Eigen::Isometry3d CsvReader::pose(std::size_t column) const {
  constexpr double kReach = 50;  // [m] of any robot
  double values[7];
  for (std::size_t i = 0; i < 7; ++i)
    values[i] = number(column + i);
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() << values[0], values[1], values[2];
  const Eigen::Quaterniond rotation(values[6], values[3], values[4], values[5]);
  if (!is_unit(rotation)) {
    const bool angles = rotation.norm() > 2;
    refuse(quaternion_fault(rotation),
           kGiveUnitQuaternion + std::string(angles ? ": this looks like angles in degrees" : ""));
  }
  if (result.translation().norm() > kReach) {
    refuse(fmt::format("position {:.6g} m away", result.translation().norm()),
           "give metres: this looks like millimetres");
  }
  result.linear() = rotation.normalized().toRotationMatrix();
  return result;
}

void CsvReader::refuse(const std::string& value, const std::string& cure) const {
  throw UnusableInput(fmt::format("{}: line {}", source_, line_), value, cure);
}

}  // namespace scan_cell_common
