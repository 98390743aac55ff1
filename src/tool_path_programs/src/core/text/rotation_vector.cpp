// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "text/rotation_vector.h"

#include <Eigen/Geometry>

namespace tool_path_programs {

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn{Eigen::Quaterniond(rotation)};
  return turn.angle() * turn.axis();
}

Eigen::Vector3d rotation_vector_near(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& old) {
  const Eigen::AngleAxisd turn{Eigen::Quaterniond(rotation)};
  Eigen::Vector3d nearest = turn.angle() * turn.axis();
  constexpr double kAngleOfNoAxis = 1e-9;
  if (turn.angle() < kAngleOfNoAxis) return nearest;
  const Eigen::Vector3d other = (turn.angle() - 2 * M_PI) * turn.axis();
  return (other - old).norm() < (nearest - old).norm() ? other : nearest;
}

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& vector) {
  const double angle = vector.stableNorm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

}  // namespace tool_path_programs
