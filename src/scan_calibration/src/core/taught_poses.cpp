// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_calibration/taught_poses.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "scan_cell_common/errors.h"

namespace scan_calibration {
namespace {

using scan_cell_common::UnusableInput;

constexpr std::size_t kPointColumns = 3;
constexpr std::size_t kPoseColumns = 7;

/// Where a value stands, for error texts.
struct Place {
  const std::string& path;
  int line;

  [[noreturn]] void refuse(const std::string& value, const std::string& cure) const {
    throw UnusableInput(path + ": line " + std::to_string(line), value, cure);
  }
};

std::size_t columns_of_header(const std::string& text, const Place& place) {
  if (text == "x,y,z") return kPointColumns;
  if (text == "x,y,z,qx,qy,qz,qw") return kPoseColumns;
  place.refuse("'" + text + "'", "begin with the header x,y,z or x,y,z,qx,qy,qz,qw");
}

std::vector<double> numbers(const std::string& text, const Place& place) {
  std::vector<double> values;
  std::istringstream stream(text);
  for (std::string field; std::getline(stream, field, ',');) {
    char* end = nullptr;
    values.push_back(std::strtod(field.c_str(), &end));
    if (end == field.c_str() || *end != '\0' || !std::isfinite(values.back())) {
      place.refuse("'" + field + "'", "give a number");
    }
  }
  return values;
}

Eigen::Isometry3d pose(const std::vector<double>& values, const Place& place) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() << values[0], values[1], values[2];
  if (values.size() == kPointColumns) return result;
  const Eigen::Quaterniond rotation(values[6], values[3], values[4], values[5]);
  constexpr double kUnit = 1e-3;
  if (!(std::abs(rotation.norm() - 1) < kUnit)) {
    place.refuse("quaternion of length " + std::to_string(rotation.norm()),
                 "give a unit quaternion qx,qy,qz,qw");
  }
  result.linear() = rotation.normalized().toRotationMatrix();
  return result;
}

}  // namespace

TaughtPoses load_taught_poses(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw scan_cell_common::FileError(path, "cannot be read", "check the path");
  TaughtPoses taught;
  std::size_t columns = 0;
  Place place{path, 0};
  for (std::string text; std::getline(file, text);) {
    ++place.line;
    if (!text.empty() && text.back() == '\r') text.pop_back();
    if (text.empty() || text.front() == '#') continue;
    if (columns == 0) {
      columns = columns_of_header(text, place);
      continue;
    }
    const std::vector<double> values = numbers(text, place);
    if (values.size() != columns) {
      place.refuse(std::to_string(values.size()) + " values",
                   "give " + std::to_string(columns) + ", as in the header");
    }
    taught.poses.push_back(pose(values, place));
  }
  taught.has_orientation = columns == kPoseColumns;
  return taught;
}

}  // namespace scan_calibration
