// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "geometry/kd_tree.h"

namespace cloud_preprocess {

/// Points that can be reached from one point by steps of at most `gap` [m], that point first.
/// @param seen one per point; points already seen are left out, and those found are marked as seen
std::vector<KdTree::Index> cluster_of(const scan_cell_common::Cloud& points, const KdTree& tree,
                                      double gap, KdTree::Index start, std::vector<bool>& seen);

/// Clusters of points connected by steps of at most `gap` [m].
std::vector<std::vector<KdTree::Index>> clusters(const scan_cell_common::Cloud& points, double gap);

}  // namespace cloud_preprocess
