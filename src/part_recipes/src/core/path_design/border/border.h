// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/surface/mesh_search.h"
#include "path_design/trace/trace.h"

namespace part_recipes::path_design {

/// The closed lines along which a mesh ends, with the surface on the left. Points at which they
/// turn, or the surface bends, by more than `corner_angle` [rad] are marked as corners.
std::vector<Trace> borders_of(const PartMesh& mesh, double corner_angle);

/// Whether a border goes around a hole or a crack, rather than around the surface.
bool is_hole(const Trace& border);

/// Width of a hole [m]: four times its area over its girth. This is the diameter of a round hole,
/// twice the width of a slot, and nothing for a crack.
double width_of(const Trace& border);

/// A border of a cloud with its noise smoothed out, by fits of second order over `reach` [m] to
/// each side, up to the corners. A corner is set where the sides before and after it meet.
Trace smoothed_border(const Trace& border, double reach, double corner_angle,
                      const MeshSearch& surface);

/// Marks the points at which a trace turns by more than an angle [rad].
void mark_corners(Trace& border, double corner_angle);

}  // namespace part_recipes::path_design
