// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>

namespace tool_path_programs {

/// X Y Z [mm] A B C [degrees], as KRL's frames have them.
using KrlNumbers = std::array<double, 6>;

constexpr std::array<const char*, 6> kKrlFields = {"X", "Y", "Z", "A", "B", "C"};

/// A about z, B about the new y, C about the new x.
Eigen::Isometry3d krl_pose(const KrlNumbers& numbers);
KrlNumbers krl_numbers(const Eigen::Isometry3d& pose);

/// Decimals of each number: lengths 1e-4 mm, angles 1e-5 degree.
inline int krl_digits(std::size_t field) {
  return field < 3 ? 4 : 5;
}

}  // namespace tool_path_programs
