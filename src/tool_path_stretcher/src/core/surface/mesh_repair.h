// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surface/mesh_topology.h"

namespace tool_path_stretcher {

/// The triangles of a mesh as they should have been exported: without degenerate (two equal
/// corners) and duplicate triangles, with consistent winding, and with closed pieces wound outside
/// out. Edges shared by three or more triangles say nothing about the winding. An open piece keeps
/// the winding of most of its area.
/// @param vertices [m] all distinct
std::vector<Triangle> repaired(const Points& vertices, const std::vector<Triangle>& triangles);

}  // namespace tool_path_stretcher
