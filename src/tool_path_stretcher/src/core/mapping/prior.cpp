// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/prior.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scan_cell_common/pose/unit_quaternion.h"

namespace tool_path_stretcher {

ScaleRange ScalePrior::range() const {
  constexpr double kDeviations = 4;  // standard: 1 in 16,000 beyond; chosen
  if (!is_known()) return {};
  const double reach = kDeviations * deviation;
  return {std::max(0.0, value - reach), value + reach};
}

bool PosePrior::allows(const Similarity& similarity, const Eigen::Vector3d& centroid) const {
  const Similarity given{similarity.scale, pose.linear(), pose.translation()};
  const Eigen::AngleAxisd between(pose.linear().transpose() * similarity.rotation);
  return between.angle() <= angle && (given * centroid - similarity * centroid).norm() <= distance;
}

bool ViewPrior::allows(const Eigen::Matrix3d& rotation) const {
  const double cosine = std::cos(std::min(angle, M_PI));
  return std::all_of(
      of_reference.begin(), of_reference.end(), [&](const Eigen::Vector3d& direction) {
        const Eigen::Vector3d turned = rotation * direction;
        return std::any_of(of_object.begin(), of_object.end(), [&](const Eigen::Vector3d& other) {
          return turned.dot(other) >= cosine;
        });
      });
}

Eigen::Isometry3d pose_from_numbers(const std::vector<double>& numbers) {
  constexpr std::size_t kNumbers = 7;
  if (numbers.size() != kNumbers) {
    throw scan_cell_common::InvalidParameter("initial_pose",
                                             fmt::format("{} numbers", numbers.size()),
                                             "give seven: x y z in metres and qx qy qz qw");
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << numbers[0], numbers[1], numbers[2];
  pose.linear() = scan_cell_common::rotation_from<scan_cell_common::InvalidParameter>(
      Eigen::Quaterniond(numbers[6], numbers[3], numbers[4], numbers[5]), "initial_pose");
  return pose;
}

bool Prior::allows(const Similarity& similarity, const Eigen::Vector3d& centroid) const {
  constexpr double kRounding = 1e-9;  // of the scale; chosen
  const ScaleRange range = scale.range();
  if (similarity.scale < (1 - kRounding) * range.least) return false;
  if (similarity.scale > (1 + kRounding) * range.most) return false;
  if (view && !view->allows(similarity.rotation)) return false;
  return !pose || pose->allows(similarity, centroid);
}

Prior Prior::widened(double angle, double distance) const {
  Prior result = *this;
  if (result.view) result.view->angle += angle;
  if (!result.pose) return result;
  result.pose->angle += angle;
  result.pose->distance += distance;
  return result;
}

}  // namespace tool_path_stretcher
