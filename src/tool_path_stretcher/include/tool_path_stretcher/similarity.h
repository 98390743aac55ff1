// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <vector>

namespace tool_path_stretcher {

using Points = std::vector<Eigen::Vector3d>;  //!< [m]

/// p_object = scale * rotation * p_reference + translation
struct Similarity {
  double scale = 1;                                        //!< above 0
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  //!< proper
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();   //!< [m]

  /// Reference to object [m].
  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return scale * (rotation * point) + translation;
  }
  /// Object to reference [m].
  Eigen::Vector3d inverse(const Eigen::Vector3d& point) const {
    return rotation.transpose() * (point - translation) / scale;
  }
  Eigen::Matrix4d matrix() const;  //!< 4 x 4, homogeneous
};

/// The rotation nearest to a matrix by least squares over its elements (Kabsch 1978).
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix);

/// RMS distance [m] between the points under the two similarities.
double distance(const Similarity& a, const Similarity& b, const Points& points);

/// Allowed scales; all by default.
struct ScaleRange {
  double least = 0;                                       //!< smallest scale
  double most = std::numeric_limits<double>::infinity();  //!< largest scale
};

/// Least-squares fit to pairs of points. Uses the symmetric scale of Horn 1987, which wrong pairs
/// do not shrink.
Similarity fit_similarity(const Points& from, const Points& to, const ScaleRange& scales = {});

}  // namespace tool_path_stretcher
