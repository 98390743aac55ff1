// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/path_parameters.h"
#include "path_design/surface/part_mesh.h"
#include "path_design/trace/slice.h"

namespace part_recipes {

/// How a raster lies on a part.
struct RasterFrame {
  Eigen::Vector3d towards;     //!< the viewer, unit length
  Eigen::Vector3d along;       //!< the rows, unit length
  path_design::Planes planes;  //!< of the rows
};

/// The rows along the given direction, or along the longest axis of the surface in the viewer's
/// picture, evenly about its middle: as many as cover it, each one spacing wide.
/// @param surface visible part of the reference
/// @throw scan_cell_common::InvalidParameter if the spacing is larger than the part, or so small
/// that there would be more than 20,000 rows
RasterFrame raster_frame(const path_design::PartMesh& surface, const SliceParameters& parameters);

}  // namespace part_recipes
