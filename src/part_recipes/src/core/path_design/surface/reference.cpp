// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/surface/reference.h"

#include <fmt/format.h>
#include <pcl/conversions.h>

#include <algorithm>
#include <cmath>

#include "path_design/surface/cloud_sheet.h"
#include "path_design/surface/mesh_search.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;

PartMesh load_part_mesh(const std::string& file, double metres_per_unit,
                        const SurfaceSettings& settings) {
  const pcl::PolygonMesh loaded = scan_cell_common::load_mesh(file, metres_per_unit);
  scan_cell_common::Cloud corners;
  pcl::fromPCLPointCloud2(loaded.cloud, corners);
  std::vector<Triangle> triangles;
  triangles.reserve(loaded.polygons.size());
  for (const pcl::Vertices& face : loaded.polygons) {
    Triangle triangle{};
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i] = static_cast<std::uint32_t>(face.vertices.at(i));
    triangles.push_back(triangle);
  }
  return joined_mesh(tool_path_stretcher::to_points(corners), triangles, settings.towards,
                     settings.crease_angle, file);
}

/// Tests its middle and places near its corners: if one is not hidden, some of the triangle is
/// seen.
bool is_hidden(const MeshSearch& search, std::uint32_t triangle, const Vector3d& towards) {
  constexpr double kMiddle = 0.1;  // of the way from a corner; chosen
  const PartMesh& mesh = search.mesh();
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Vector3d middle = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
  if (!search.is_hidden(middle, towards)) return false;
  for (const std::uint32_t corner : {a, b, c}) {
    const Vector3d place = kMiddle * middle + (1 - kMiddle) * mesh.vertices[corner];
    if (!search.is_hidden(place, towards)) return false;
  }
  return true;
}

}  // namespace

PartMesh load_reference(const std::string& file, double metres_per_unit,
                        const SurfaceSettings& settings) {
  if (scan_cell_common::is_mesh_file(file)) return load_part_mesh(file, metres_per_unit, settings);
  const auto cloud =
      tool_path_stretcher::load_surface(file, Vector3d::Constant(settings.leaf), metres_per_unit);
  return sheet_of(cloud, settings.towards, file);
}

PartMesh seen_part(const PartMesh& mesh, const Vector3d& towards) {
  constexpr double kGrazing = 0.087;  // cosine: 85 degrees; chosen
  const MeshSearch search(mesh);
  std::vector<std::uint32_t> seen;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.facets[t].dot(towards) > kGrazing && !is_hidden(search, t, towards)) seen.push_back(t);
  }
  if (!seen.empty()) return part_of(mesh, seen);
  throw scan_cell_common::UnusableInput("reference", "none of its surface faces the viewer",
                                        "give the side to work on by --from");
}

PartMesh face_around(const PartMesh& mesh, const Vector3d& near, double crease_angle) {
  constexpr double kFarthest = 0.01;  // [m]; chosen
  const Foot foot = MeshSearch(mesh).nearest(near);
  if (!(foot.distance <= kFarthest)) {
    throw scan_cell_common::Refused("near",
                                    fmt::format("{:.3g} mm from the surface", 1e3 * foot.distance),
                                    "give a place on the face, in metres");
  }
  std::vector<bool> known(mesh.triangles.size(), false);
  std::vector<std::uint32_t> face = {foot.triangle};
  known[foot.triangle] = true;
  for (std::size_t i = 0; i < face.size(); ++i) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const std::uint32_t next = mesh.beside[face[i]][edge];
      if (next == kNoTriangle || known[next] ||
          bend_at(mesh, face[i], edge) < std::cos(crease_angle))
        continue;
      known[next] = true;
      face.push_back(next);
    }
  }
  std::sort(face.begin(), face.end());
  return part_of(mesh, face);
}

}  // namespace part_recipes::path_design
