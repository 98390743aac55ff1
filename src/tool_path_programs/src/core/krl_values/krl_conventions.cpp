// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "krl_values/krl_conventions.h"

#include <cmath>

#include "scan_cell_common/pose/euler_angles.h"

namespace tool_path_programs {
namespace {

const scan_cell_common::EulerSequence& abc() {
  static const scan_cell_common::EulerSequence sequence("zyx");
  return sequence;
}

}  // namespace

Eigen::Isometry3d krl_pose(const KrlNumbers& numbers) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]) / 1000;
  pose.linear() =
      abc().rotation(Eigen::Vector3d(numbers[3], numbers[4], numbers[5]) * (M_PI / 180));
  return pose;
}

KrlNumbers krl_numbers(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d position = pose.translation() * 1000;
  const Eigen::Vector3d angles = abc().angles(pose.linear()) * (180 / M_PI);
  return {position.x(), position.y(), position.z(), angles.x(), angles.y(), angles.z()};
}

}  // namespace tool_path_programs
