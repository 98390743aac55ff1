// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/surface/part_mesh.h"

namespace part_recipes::path_design {

/// The triangles beyond the edges of each triangle, whichever way they are wound. If more than two
/// meet at an edge, none of them is a neighbour of another there.
std::vector<std::array<std::uint32_t, 3>> neighbours_of(const std::vector<Triangle>& triangles);

/// Winds the triangles of each shell alike, and finds the neighbours: see joined_mesh().
/// @param towards unit length
void wind_alike(PartMesh& mesh, const Eigen::Vector3d& towards);

}  // namespace part_recipes::path_design
