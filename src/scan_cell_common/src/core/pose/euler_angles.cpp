// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/pose/euler_angles.h"

#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace scan_cell_common {
namespace {

bool is_sequence(const std::string& axes) {
  return axes.size() == 3 && axes.find_first_not_of("xyz") == std::string::npos &&
         axes[0] != axes[1] && axes[1] != axes[2];
}

/// Turns -pi into pi.
double half_open(double angle) {
  return angle <= -M_PI ? M_PI : angle;
}

}  // namespace

EulerSequence::EulerSequence(const std::string& axes) : axes_(lower_case(axes)) {
  if (!is_sequence(axes_)) {
    throw InvalidParameter("sequence of Euler angles", "'" + excerpt(axes) + "'",
                           "give three axes in the order of the turns, such as zyx or zyz");
  }
  order_[0] = axes_[0] - 'x';
  order_[1] = axes_[1] - 'x';
  order_[2] = 3 - order_[0] - order_[1];
  sign_ = (order_[0] + 1) % 3 == order_[1] ? 1 : -1;
}

Eigen::Matrix3d EulerSequence::rotation(const Eigen::Vector3d& angles) const {
  Eigen::Matrix3d result = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(axes_[static_cast<std::size_t>(i)] - 'x');
    result = result * Eigen::AngleAxisd(angles[i], axis).toRotationMatrix();
  }
  return result;
}

Eigen::Vector3d EulerSequence::angles(const Eigen::Matrix3d& rotation) const {
  constexpr double kDegenerate = 1e-12;
  const auto [i, j, k] = order_;
  // After the first two rotations, the third axis lies beside the first axis, at the first angle.
  const Eigen::Vector3d third = rotation.col(axes_[2] - 'x');
  const double beside = std::hypot(third[j], third[k]);
  Eigen::Vector3d result;
  if (repeats()) {
    result[0] = beside > kDegenerate ? std::atan2(third[j], -sign_ * third[k]) : 0;
    result[1] = std::atan2(beside, third[i]);
  } else {
    result[0] = beside > kDegenerate ? std::atan2(-sign_ * third[j], third[k]) : 0;
    result[1] = std::atan2(sign_ * third[i], beside);
  }
  // The third angle is what remains after the first: the second rotation leaves this row unchanged.
  // Taken from the rotation alone, it would not match the first angle near a degenerate place.
  const Eigen::RowVector3d row =
      std::cos(result[0]) * rotation.row(j) + sign_ * std::sin(result[0]) * rotation.row(k);
  result[2] = repeats() ? std::atan2(-sign_ * row[k], row[j]) : std::atan2(sign_ * row[i], row[j]);
  return {half_open(result[0]), result[1], half_open(result[2])};
}

}  // namespace scan_cell_common
