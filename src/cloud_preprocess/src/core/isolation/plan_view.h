// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "scan_cell_common/clouds/cloud_files.h"

namespace cloud_preprocess {

/// Projects points onto the floor along its normal.
class PlanView {
 public:
  /// @param up unit length
  explicit PlanView(const Eigen::Vector3f& up)
      : along_(up.unitOrthogonal()), across_(up.cross(along_)) {}

  pcl::PointXYZ operator()(const pcl::PointXYZ& point) const {
    const auto at = point.getVector3fMap();
    return {along_.dot(at), across_.dot(at), 0};
  }

 private:
  Eigen::Vector3f along_;
  Eigen::Vector3f across_;
};

}  // namespace cloud_preprocess
