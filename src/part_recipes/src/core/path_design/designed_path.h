// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "path_design/path_parameters.h"
#include "path_design/surface/part_mesh.h"
#include "tool_paths/tool_path.h"

namespace part_recipes {

/// A path made from a reference.
struct DesignedPath {
  tool_paths::ToolPath path;       //!< [m] in the reference's frame
  std::vector<std::string> notes;  //!< what was left out or bridged, for a person
};

/// A reference as these commands take it: a mesh, or the visible side of a cloud.
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput
path_design::PartMesh load_reference_surface(const std::string& file, double metres_per_unit,
                                             const PathParameters& parameters);

/// A path along the edges of a part, or of a face of it.
/// @throw scan_cell_common::InvalidParameter naming what is out of range
/// @throw scan_cell_common::Refused if there is no such edge, or no room for the offset
DesignedPath path_from_edge(const path_design::PartMesh& reference,
                            const EdgeParameters& parameters);

/// A raster over the visible side of a part.
/// @throw as path_from_edge()
DesignedPath path_from_slices(const path_design::PartMesh& reference,
                              const SliceParameters& parameters);

/// A path through picked points: a centripetal Catmull-Rom spline (Yuksel et al. 2011), projected
/// onto the surface.
/// @param picks [m]
/// @throw as path_from_edge(); Refused names the pick that is too far from the surface
DesignedPath path_from_picks(const path_design::PartMesh& reference,
                             const path_design::Points& picks, const PickParameters& parameters);

}  // namespace part_recipes
