// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/pose/unit_quaternion.h"

#include <fmt/format.h>

#include <cmath>

namespace scan_cell_common {

bool is_unit(const Eigen::Quaterniond& quaternion) {
  constexpr double kTolerance = 1e-3;  // chosen: ten times the rounding of four decimals
  return std::abs(quaternion.norm() - 1) < kTolerance;
}

std::string quaternion_fault(const Eigen::Quaterniond& quaternion) {
  return fmt::format("a quaternion of length {:.6g}", quaternion.norm());
}

}  // namespace scan_cell_common
