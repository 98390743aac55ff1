// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "deviation/reference/mesh_reference.h"

#include <pcl/conversions.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <utility>

#include "scan_cell_common/clouds/cloud_files.h"
#include "tool_path_stretcher/surface.h"

namespace part_recipes {
namespace {

using Eigen::Vector3d;
using path_design::Foot;
using path_design::PartMesh;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

PartMesh joined(const pcl::PolygonMesh& mesh, const std::string& name) {
  scan_cell_common::Cloud corners;
  pcl::fromPCLPointCloud2(mesh.cloud, corners);
  std::vector<path_design::Triangle> triangles;
  triangles.reserve(mesh.polygons.size());
  for (const pcl::Vertices& face : mesh.polygons) {
    path_design::Triangle triangle{};
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i] = static_cast<std::uint32_t>(face.vertices.at(i));
    triangles.push_back(triangle);
  }
  // No edge is a crease: the mean normal of all facets around tells the sides of a corner apart
  // (Baerentzen and Aanaes 2005)
  return path_design::joined_mesh(tool_path_stretcher::to_points(corners), triangles,
                                  Vector3d::UnitZ(), M_PI, name);
}

/// Whether a place lies on an edge where the surface ends.
bool on_border(const PartMesh& mesh, const Foot& foot) {
  constexpr double kOn = 1e-9;  // [m]; rounding of the foot
  const path_design::Triangle& corners = mesh.triangles[foot.triangle];
  for (std::size_t i = 0; i < 3; ++i) {
    if (mesh.beside[foot.triangle][i] != path_design::kNoTriangle) continue;
    const Vector3d& from = mesh.vertices[corners[i]];
    const Vector3d along = (mesh.vertices[corners[(i + 1) % 3]] - from).normalized();
    const Vector3d way = foot.point - from;
    if ((way - way.dot(along) * along).norm() <= kOn) return true;
  }
  return false;
}

/// Whether the mesh encloses the part: the normals of a closed mesh cancel out. The winding uses
/// the same test.
bool is_closed(const PartMesh& mesh) {
  constexpr double kClosed = 0.02;  // of the area; as path_design::joined_mesh() takes it
  Vector3d facing = Vector3d::Zero();
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double own = path_design::area_of(mesh, t);
    facing += own * mesh.facets[t];
    area += own;
  }
  return facing.norm() <= kClosed * area;
}

ReferenceSurface::Samples samples_of(const tool_path_stretcher::Surface& surface) {
  return {surface.points, surface.normals, surface.spacing};
}

}  // namespace

MeshReference::MeshReference(const pcl::PolygonMesh& mesh,
                             const tool_path_stretcher::Surface& surface, const std::string& name)
    : MeshReference(joined(mesh, name), surface) {}

MeshReference::MeshReference(path_design::PartMesh&& mesh,
                             const tool_path_stretcher::Surface& surface)
    : ReferenceSurface(samples_of(surface),
                       is_closed(mesh) ? OutsideKnownBy::kClosedMesh : OutsideKnownBy::kUpwards),
      mesh_(std::move(mesh)),
      search_(mesh_) {}

double MeshReference::signed_distance(const Vector3d& point, const Reach& reach) const {
  const Foot foot = search_.nearest(point);
  if (!(foot.distance <= reach.normal + reach.lateral)) return kNaN;
  const Vector3d way = point - foot.point;
  if (!on_border(mesh_, foot)) {
    if (foot.distance > reach.normal) return kNaN;
    return way.dot(foot.normal) < 0 ? -foot.distance : foot.distance;
  }
  const Vector3d& facet = mesh_.facets[foot.triangle];
  const double height = way.dot(facet);
  if (std::abs(height) > reach.normal || (way - height * facet).norm() > reach.lateral) return kNaN;
  return height;
}

}  // namespace part_recipes
