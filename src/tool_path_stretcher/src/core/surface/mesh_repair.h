// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surface/mesh_topology.h"

namespace tool_path_stretcher {

/// The triangles of a mesh as they should have been exported: without those of two equal corners
/// and those that are there twice, neighbours wound alike, and pieces that enclose something wound
/// with the outside out. Where three and more triangles meet along an edge nothing is concluded
/// from it. An open piece keeps the winding of most of its area.
/// @param vertices [m] no two in the same place
std::vector<Triangle> repaired(const Points& vertices, const std::vector<Triangle>& triangles);

}  // namespace tool_path_stretcher
