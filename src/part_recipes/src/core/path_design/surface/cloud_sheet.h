// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/surface/part_mesh.h"
#include "tool_path_stretcher/surface.h"

namespace part_recipes::path_design {

/// The side of a cloud that a viewer sees, as a mesh. Its points are smoothed by quadratic fits to
/// the neighbours on the same side of a sharp edge (moving least squares, Levin 1998). Neighbours
/// in the viewer's picture (Delaunay) are joined, if they are no farther apart than three times the
/// pitch of the cloud, which becomes the mesh's spacing.
/// @param towards the viewer, unit length
/// @param name of the cloud in error messages
/// @throw scan_cell_common::UnusableInput if nothing faces the viewer
PartMesh sheet_of(const tool_path_stretcher::Surface& cloud, const Eigen::Vector3d& towards,
                  const std::string& name);

}  // namespace part_recipes::path_design
