// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>

namespace tool_path_programs {

/// X Y Z [mm] A E R [degrees], as POS has them.
using Pdl2Numbers = std::array<double, 6>;

/// A about z, E about the new y, R about the new z.
Eigen::Isometry3d pdl2_pose(const Pdl2Numbers& numbers);
Pdl2Numbers pdl2_numbers(const Eigen::Isometry3d& pose);

/// Decimals of each number: lengths 1e-4 mm, angles 1e-5 degree.
inline int pdl2_digits(std::size_t field) {
  return field < 3 ? 4 : 5;
}

}  // namespace tool_path_programs
