// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tool_path_stretcher/similarity.h"

namespace tool_path_stretcher {

/// Indices of the corners.
using Triangle = std::array<std::uint32_t, 3>;

/// What the triangles of a mesh tell about its sides.
struct MeshTopology {
  bool oriented = false;    //!< they agree on which side is out; if closed, a few may not
  bool closed = false;      //!< oriented, and they enclose the part except for small holes
  bool inside_out = false;  //!< closed, and wound inside out
};

/// @param vertices [m] all distinct
/// @param triangles at least one
/// @param area [m^2] of all triangles
MeshTopology topology_of(const Points& vertices, const std::vector<Triangle>& triangles,
                         double area);

}  // namespace tool_path_stretcher
