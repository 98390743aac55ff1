// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "cloud_preprocess/floor_removal.h"

namespace cloud_preprocess {

struct Plane {
  Eigen::Vector3d point;   //!< [m] the middle of its points
  Eigen::Vector3d normal;  //!< of length 1, upwards

  /// [m] above the plane
  double height(const pcl::PointXYZ& of) const {
    return normal.dot(of.getVector3fMap().cast<double>() - point);
  }
};

/// The floor as FloorRemoval describes it; none if the cloud shows none.
std::optional<Plane> find_floor(const Cloud& cloud, const FloorParameters& parameters);

}  // namespace cloud_preprocess
