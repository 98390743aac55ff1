// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "scan_cell_common/errors.h"

namespace tool_path_stretcher {

std::string to_text(double number) {
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() ? std::string(text.data(), end) : "nan";
}

Eigen::Matrix3d rotation_from(const Eigen::Vector4d& xyzw, const std::string& where) {
  constexpr double kUnit = 1e-3;
  if (!(std::abs(xyzw.norm() - 1) < kUnit)) {
    throw scan_cell_common::UnusableInput(where, "a quaternion of length " + to_text(xyzw.norm()),
                                          "give unit quaternions x y z w");
  }
  return Eigen::Quaterniond(xyzw).normalized().toRotationMatrix();
}

}  // namespace tool_path_stretcher
