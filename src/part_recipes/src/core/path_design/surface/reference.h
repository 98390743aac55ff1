// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "path_design/surface/part_mesh.h"

namespace part_recipes::path_design {

/// How a reference becomes a surface.
struct SurfaceSettings {
  double leaf = 0.001;                                 //!< [m] grid on which a cloud is reduced
  Eigen::Vector3d towards = Eigen::Vector3d::UnitZ();  //!< the viewer, unit length
  double crease_angle = 0.5236;                        //!< [rad] of a sharp edge
};

/// A reference from a mesh, or from the side of a cloud that the viewer sees.
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput
PartMesh load_reference(const std::string& file, double metres_per_unit,
                        const SurfaceSettings& settings);

/// The triangles that face a viewer, with nothing of the part in front of them.
/// @param towards the viewer, unit length
/// @throw scan_cell_common::UnusableInput if there is none
PartMesh seen_part(const PartMesh& mesh, const Eigen::Vector3d& towards);

/// The face around a place, up to the sharp edges around it.
/// @param near [m]
/// @throw scan_cell_common::Refused if the place is farther than 10 mm from the surface
PartMesh face_around(const PartMesh& mesh, const Eigen::Vector3d& near, double crease_angle);

}  // namespace part_recipes::path_design
