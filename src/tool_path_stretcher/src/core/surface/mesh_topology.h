// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tool_path_stretcher/similarity.h"

namespace tool_path_stretcher {

/// Indices of its corners.
using Triangle = std::array<std::uint32_t, 3>;

/// What the triangles of a mesh say of its sides.
struct MeshTopology {
  bool oriented = false;    //!< they agree on which side is out, but for few where it is closed
  bool closed = false;      //!< oriented, and they enclose the part but for small holes
  bool inside_out = false;  //!< closed, and wound so that the inside is out
};

/// @param vertices [m] no two in the same place
/// @param triangles at least one
/// @param area [m^2] of all of them
MeshTopology topology_of(const Points& vertices, const std::vector<Triangle>& triangles,
                         double area);

}  // namespace tool_path_stretcher
