// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/prior.h"

#include <algorithm>
#include <cmath>

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
