// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PolygonMesh.h>

#include "scan_cell_sim/shapes.h"
#include "tool_path_stretcher/similarity.h"

namespace scanner_views {

using scan_cell_sim::Mesh;
using tool_path_stretcher::Points;

/// Puts triangles together, each with corners of its own; seen from outside they turn left.
class MeshBuilder {
 public:
  /// A triangle without area is left out.
  void triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);
  void quad(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
            const Eigen::Vector3d& d);

  /// Between two closed lines of as many points: the inner side is left of the way from `from` to
  /// `to`, seen along the lines.
  void band(const Points& from, const Points& to);

  Mesh take() { return std::move(mesh_); }

 private:
  Mesh mesh_;
};

/// Edges halved until none is longer [m]; neighbours stay joined.
Mesh refined(const Mesh& mesh, double longest);

/// Each corner where `place` puts it.
template <class Place>
Mesh moved(Mesh mesh, const Place& place) {
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex = place(vertex);
  return mesh;
}

/// [m] of the box around it
Eigen::AlignedBox3d box_of(const Mesh& mesh);

/// [m^3] enclosed by a closed mesh; above 0 if its triangles turn left seen from outside
double volume_of(const Mesh& mesh);

pcl::PolygonMesh to_polygon_mesh(const Mesh& mesh);
Mesh from_polygon_mesh(const pcl::PolygonMesh& mesh);

}  // namespace scanner_views
