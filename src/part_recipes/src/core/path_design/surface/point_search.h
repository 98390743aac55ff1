// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "scan_cell_common/geometry/kd_tree.h"

namespace part_recipes::path_design {

/// Behind PointSearch.
struct PointCoordinate {
  double operator()(const Eigen::Vector3d& point, std::size_t axis) const {
    return point[static_cast<Eigen::Index>(axis)];
  }
};

/// A kd-tree of points [m].
using PointSearch = scan_cell_common::KdTree<std::vector<Eigen::Vector3d>, PointCoordinate, double>;

}  // namespace part_recipes::path_design
