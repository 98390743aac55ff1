// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "geometry/kd_tree.h"

namespace tool_path_stretcher {

/// Points that can be reached from each other by steps of at most `gap` [m], the largest cluster
/// first.
/// @param linked whether a step may lead from one point to another; none: any
std::vector<std::vector<std::size_t>> clusters(
    const KdTree& tree, double gap,
    const std::function<bool(std::size_t, std::size_t)>& linked = {});

}  // namespace tool_path_stretcher
