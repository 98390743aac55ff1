// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fanuc_reader/fanuc_angles.h"

#include <cmath>

#include "scan_cell_common/pose/euler_angles.h"

namespace tool_path_programs {
namespace {

constexpr double kRadian = M_PI / 180;

Eigen::Matrix3d about(const Eigen::Vector3d& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * kRadian, axis).toRotationMatrix();
}

double rounded(double value, int digits) {
  const double scale = std::pow(10, digits);
  return std::round(value * scale) / scale;
}

}  // namespace

Eigen::Isometry3d pose_of(const FanucPose& numbers) {
  static const scan_cell_common::EulerSequence sequence("zyx");
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = 1e-3 * Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  pose.linear() = sequence.rotation(kRadian * Eigen::Vector3d(numbers[5], numbers[4], numbers[3]));
  return pose;
}

FanucPose fanuc_pose(const Eigen::Isometry3d& pose, const std::array<int, 3>& digits) {
  static const scan_cell_common::EulerSequence sequence("zyx");
  const Eigen::Vector3d place = 1e3 * pose.translation();
  const Eigen::Vector3d angles = sequence.angles(pose.linear()) / kRadian;
  const double r = rounded(angles[0], digits[2]);
  const double p = rounded(angles[1], digits[1]);
  // W compensates the rounding of R, where it acts about W's axis.
  const Eigen::Matrix3d left =
      about(Eigen::Vector3d::UnitY(), -p) * about(Eigen::Vector3d::UnitZ(), -r) * pose.linear();
  const double w = std::atan2(left(2, 1) - left(1, 2), left(1, 1) + left(2, 2)) / kRadian;
  return {place.x(), place.y(), place.z(), rounded(w, digits[0]), p, r};
}

}  // namespace tool_path_programs
