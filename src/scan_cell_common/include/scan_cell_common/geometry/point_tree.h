// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "scan_cell_common/geometry/kd_tree.h"

namespace scan_cell_common {

/// Implementation of PointTree.
struct PointCoordinate {
  /// @param axis 0 .. 2
  double operator()(const Eigen::Vector3d& point, std::size_t axis) const {
    return point[static_cast<Eigen::Index>(axis)];
  }
};

/// A kd-tree of points.
using PointTree = KdTree<std::vector<Eigen::Vector3d>, PointCoordinate, double>;

}  // namespace scan_cell_common
