// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "geometry/kd_tree.h"

namespace cloud_preprocess {

/// Points that can be reached from one of them by steps of at most `gap` [m], that one first.
/// @param seen one a point; those that are seen already are left out, and these are seen then
std::vector<KdTree::Index> cluster_of(const scan_cell_common::Cloud& points, const KdTree& tree,
                                      double gap, KdTree::Index start, std::vector<bool>& seen);

/// Points that can be reached from each other by steps of at most `gap` [m], cluster by cluster.
std::vector<std::vector<KdTree::Index>> clusters(const scan_cell_common::Cloud& points, double gap);

}  // namespace cloud_preprocess
