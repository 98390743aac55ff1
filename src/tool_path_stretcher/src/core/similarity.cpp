// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/similarity.h"

#include <cmath>

namespace tool_path_stretcher {

Eigen::Matrix4d Similarity::matrix() const {
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  result.topLeftCorner<3, 3>() = scale * rotation;
  result.topRightCorner<3, 1>() = translation;
  return result;
}

double distance(const Similarity& a, const Similarity& b, const Points& points) {
  double sum = 0;
  for (const Eigen::Vector3d& point : points)
    sum += (a * point - b * point).squaredNorm();
  return std::sqrt(sum / static_cast<double>(points.size()));
}

}  // namespace tool_path_stretcher
