// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/prior.h"

#include <algorithm>
#include <cmath>

#include "path/number_text.h"
#include "scan_cell_common/errors.h"

namespace tool_path_stretcher {

ScaleRange ScalePrior::range() const {
  constexpr double kDeviations = 4;
  if (!is_known()) return {};
  const double reach = kDeviations * deviation;
  return {std::max(0.0, value - reach), value + reach};
}

bool PosePrior::allows(const Similarity& similarity, const Eigen::Vector3d& centroid) const {
  const Similarity given{similarity.scale, pose.linear(), pose.translation()};
  const Eigen::AngleAxisd between(pose.linear().transpose() * similarity.rotation);
  return between.angle() <= angle && (given * centroid - similarity * centroid).norm() <= distance;
}

Eigen::Isometry3d pose_from_numbers(const std::vector<double>& numbers) {
  constexpr std::size_t kNumbers = 7;
  if (numbers.size() != kNumbers) {
    throw scan_cell_common::InvalidParameter("initial_pose",
                                             std::to_string(numbers.size()) + " numbers",
                                             "give seven: x y z in metres and qx qy qz qw");
  }
  const Eigen::Vector4d xyzw(numbers[3], numbers[4], numbers[5], numbers[6]);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << numbers[0], numbers[1], numbers[2];
  try {
    pose.linear() = rotation_from(xyzw, "initial_pose");
  } catch (const scan_cell_common::UnusableInput& error) {
    throw scan_cell_common::InvalidParameter(
        "initial_pose", "a quaternion of length " + std::to_string(xyzw.norm()),
        "give a unit quaternion qx qy qz qw");
  }
  return pose;
}

bool Prior::allows(const Similarity& similarity, const Eigen::Vector3d& centroid) const {
  constexpr double kRounding = 1e-9;
  const ScaleRange range = scale.range();
  if (similarity.scale < (1 - kRounding) * range.least) return false;
  if (similarity.scale > (1 + kRounding) * range.most) return false;
  return !pose || pose->allows(similarity, centroid);
}

Prior Prior::widened(double angle, double distance) const {
  Prior result = *this;
  if (!result.pose) return result;
  result.pose->angle += angle;
  result.pose->distance += distance;
  return result;
}

}  // namespace tool_path_stretcher
