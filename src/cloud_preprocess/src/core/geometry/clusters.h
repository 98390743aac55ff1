// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "geometry/kd_tree.h"

namespace cloud_preprocess {

/// Points that can be reached from one point by steps shorter than `gap` [m], with that point.
/// @throw scan_cell_common::UnusableInput if a coordinate is not finite
std::vector<KdTree::Index> cluster_of(const scan_cell_common::Cloud& points, double gap,
                                      KdTree::Index start);

/// Clusters of points connected by steps shorter than `gap` [m], each in the order of its points,
/// and ordered by their first points.
/// @throw scan_cell_common::UnusableInput if a coordinate is not finite
std::vector<std::vector<KdTree::Index>> clusters(const scan_cell_common::Cloud& points, double gap);

}  // namespace cloud_preprocess
