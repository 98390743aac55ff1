// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// The rim of a surface, and the edges where it continues around a corner.
/// @param surface with points, normals, tree, spacing and rim
Rim edges_of(const Surface& surface);

/// The nearest of the few nearest edges that faces about the same way; none if none does.
/// @param at [m] @param outward unit length
std::optional<std::size_t> edge_facing(const Rim& edges, const Eigen::Vector3d& at,
                                       const Eigen::Vector3d& outward);

}  // namespace tool_path_stretcher
