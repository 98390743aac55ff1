// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/geometry/kd_tree.h"

namespace cloud_preprocess {

struct CloudCoordinate {
  float operator()(const pcl::PointXYZ& point, std::size_t axis) const { return point.data[axis]; }
};

using KdTree = scan_cell_common::KdTree<scan_cell_common::Cloud, CloudCoordinate, float>;

}  // namespace cloud_preprocess
