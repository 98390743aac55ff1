// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "search/candidates.h"
#include "tool_path_stretcher/tool_path.h"

namespace tool_path_stretcher {

/// Sorts by how well they explain the object, best first.
void sort_best_first(std::vector<Fitted>& fitted);

/// Drops those that have converged to where a better one is.
void drop_doubles(const Surface& reference, std::vector<Fitted>& fitted);

/// Keeps a few of those that explain the object about as well as the first, so that the rest of the
/// work stays short. Those that lay the path elsewhere go first, since they decide.
/// @param tolerance [m] between paths that are the same
void keep_few(const ToolPath& path, double tolerance, std::vector<Fitted>& fitted);

/// Of those that explain the object as well as the first, puts the one nearest to the given pose
/// first.
/// @param middle centre of the reference [m]
void prefer_given_pose(const PosePrior& given, const Eigen::Vector3d& middle,
                       std::vector<Fitted>& fitted);

}  // namespace tool_path_stretcher
