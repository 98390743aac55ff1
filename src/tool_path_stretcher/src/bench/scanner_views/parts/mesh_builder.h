// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PolygonMesh.h>

#include "scan_cell_sim/shapes.h"
#include "tool_path_stretcher/similarity.h"

namespace scanner_views {

using scan_cell_sim::Mesh;
using tool_path_stretcher::Points;

/// Builds a mesh of triangles with separate corners, counter-clockwise seen from outside.
class MeshBuilder {
 public:
  /// Adds a triangle, unless it has no area.
  void triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);
  void quad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
            const Eigen::Vector3d& d);

  /// Adds a band between two closed lines with equally many points. The inside is left of the
  /// direction from `from` to `to`, seen along the lines.
  void band(const Points& from, const Points& to);

  Mesh take() { return std::move(mesh_); }

 private:
  Mesh mesh_;
};

/// Halves edges until none is longer than `longest` [m]; neighbours stay joined.
Mesh refined(const Mesh& mesh, double longest);

/// Moves each corner to where `place` puts it.
template <class Place>
Mesh moved(Mesh mesh, const Place& place) {
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex = place(vertex);
  return mesh;
}

/// Bounding box [m].
Eigen::AlignedBox3d box_of(const Mesh& mesh);

/// Volume [m^3] of a closed mesh; above 0 if its triangles are counter-clockwise seen from outside.
double volume_of(const Mesh& mesh);

pcl::PolygonMesh to_polygon_mesh(const Mesh& mesh);
Mesh from_polygon_mesh(const pcl::PolygonMesh& mesh);

}  // namespace scanner_views
