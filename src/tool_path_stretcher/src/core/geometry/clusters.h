// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "geometry/kd_tree.h"

namespace tool_path_stretcher {

/// Clusters of points that are connected by steps of at most `gap` [m], largest first.
/// @param linked whether a step may lead from one point to another; empty: always
std::vector<std::vector<std::size_t>> clusters(
    const KdTree& tree, double gap,
    const std::function<bool(std::size_t, std::size_t)>& linked = {});

}  // namespace tool_path_stretcher
