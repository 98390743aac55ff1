// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/surface/part_mesh.h"

namespace part_recipes::path_design {

/// Computes the normals of the smooth surface at the corners of a mesh: see joined_mesh(). Where a
/// face ends, all facets lie on one side of the corner, and their mean leans to it: there the
/// normal keeps turning as it does from the next corners to the facets.
/// @param mesh with facets and neighbours
void compute_corner_normals(PartMesh& mesh, double crease_angle);

}  // namespace part_recipes::path_design
