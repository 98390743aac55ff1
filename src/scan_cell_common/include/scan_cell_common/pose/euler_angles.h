// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>

namespace scan_cell_common {

/// A convention of Euler angles: three rotations one after the other, each about an axis of the
/// frame as rotated so far. "zyx" is R = Rz(first) Ry(second) Rx(third), which is also roll, pitch,
/// yaw about fixed axes (third, second, first).
class EulerSequence {
 public:
  /// @param axes three of x, y, z, no two neighbours the same: "zyx", "zyz"
  /// @throw InvalidParameter if they are not
  explicit EulerSequence(const std::string& axes);

  /// @param angles [rad] in the order of the rotations
  Eigen::Matrix3d rotation(const Eigen::Vector3d& angles) const;

  /// The angles [rad] of a rotation, -pi < angle <= pi, in the order of the rotations. The second
  /// one is from -pi/2 to pi/2, or from 0 to pi if the first axis is repeated. If the first and the
  /// third axis are parallel, only the sum or difference of their angles is defined, and the first
  /// angle is 0. Also exact near these places.
  Eigen::Vector3d angles(const Eigen::Matrix3d& rotation) const;

  const std::string& axes() const { return axes_; }  //!< such as zyx

  /// Whether the first axis is repeated as the third.
  bool repeats() const { return axes_[0] == axes_[2]; }

 private:
  std::string axes_;
  std::array<Eigen::Index, 3> order_{};  // the first axis, the second, and the one left
  double sign_ = 1;                      // of that order: x y z is 1, x z y is -1
};

}  // namespace scan_cell_common
