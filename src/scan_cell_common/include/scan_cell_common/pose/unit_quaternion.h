// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {

/// Whether its length is 1 +- 0.001, which allows quaternions written with four decimals; false if
/// it is not finite.
bool is_unit(const Eigen::Quaterniond& quaternion);

/// "a quaternion of length 0.5"
std::string quaternion_fault(const Eigen::Quaterniond& quaternion);

/// The cure in an error about a quaternion.
constexpr const char* kGiveUnitQuaternion = "give a unit quaternion qx qy qz qw";

/// The rotation of a quaternion from a file, a parameter or a message, normalised.
/// @param thing that has the quaternion, for the error
/// @throw Kind of error if is_unit() is false
template <class Kind = UnusableInput>
Eigen::Matrix3d rotation_from(const Eigen::Quaterniond& quaternion, const std::string& thing,
                              const std::string& cure = kGiveUnitQuaternion) {
  if (!is_unit(quaternion)) throw Kind(thing, quaternion_fault(quaternion), cure);
  return quaternion.normalized().toRotationMatrix();
}

}  // namespace scan_cell_common
