// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PolygonMesh.h>

#include <string>

#include "deviation/reference/reference_surface.h"
#include "path_design/surface/mesh_search.h"

namespace tool_path_stretcher {
struct Surface;
}

namespace part_recipes {

/// A reference that is a mesh: distances are to its triangles.
class MeshReference final : public ReferenceSurface {
 public:
  /// @param surface the samples of the mesh
  /// @param name of the mesh in error messages
  /// @throw scan_cell_common::UnusableInput if the mesh has no area or vertices that are not finite
  MeshReference(const pcl::PolygonMesh& mesh, const tool_path_stretcher::Surface& surface,
                const std::string& name);

  double signed_distance(const Eigen::Vector3d& point, const Reach& reach) const override;

 private:
  MeshReference(path_design::PartMesh&& mesh, const tool_path_stretcher::Surface& surface);

  path_design::PartMesh mesh_;
  path_design::MeshSearch search_;
};

}  // namespace part_recipes
