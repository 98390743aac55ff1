// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/similarity.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace tool_path_stretcher {

Eigen::Matrix4d Similarity::matrix() const {
  Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
  result.topLeftCorner<3, 3>() = scale * rotation;
  result.topRightCorner<3, 1>() = translation;
  return result;
}

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d handed = Eigen::Matrix3d::Identity();
  handed(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  return svd.matrixU() * handed * svd.matrixV().transpose();
}

double distance(const Similarity& a, const Similarity& b, const Points& points) {
  double sum = 0;
  for (const Eigen::Vector3d& point : points)
    sum += (a * point - b * point).squaredNorm();
  return std::sqrt(sum / static_cast<double>(points.size()));
}

Similarity fit_similarity(const Points& from, const Points& to, const ScaleRange& scales) {
  Eigen::Vector3d from_mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d to_mean = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) {
    from_mean += from[i];
    to_mean += to[i];
  }
  from_mean /= static_cast<double>(from.size());
  to_mean /= static_cast<double>(to.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double from_squares = 0;
  double to_squares = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    covariance += (to[i] - to_mean) * (from[i] - from_mean).transpose();
    from_squares += (from[i] - from_mean).squaredNorm();
    to_squares += (to[i] - to_mean).squaredNorm();
  }
  Similarity result;
  result.rotation = nearest_rotation(covariance);
  result.scale = from_squares > 0 ? std::sqrt(to_squares / from_squares) : 1;
  result.scale = std::clamp(result.scale, scales.least, scales.most);
  result.translation = to_mean - result.scale * (result.rotation * from_mean);
  return result;
}

}  // namespace tool_path_stretcher
