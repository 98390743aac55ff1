// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/surface/part_mesh.h"
#include "tool_path_stretcher/surface.h"

namespace part_recipes::path_design {

/// Points on a smooth surface, with its normals.
struct SmoothedCloud {
  Points points;   //!< [m]
  Points normals;  //!< unit length, on the viewer's side
};

/// Projects each point of a cloud onto a quadratic fit to its neighbours, without those beyond a
/// sharp edge. A point at an edge belongs to the face that shows the viewer more of itself, and is
/// left out if it lies on neither.
/// @param towards the viewer, unit length
SmoothedCloud smoothed(const tool_path_stretcher::Surface& cloud, const Eigen::Vector3d& towards);

}  // namespace part_recipes::path_design
