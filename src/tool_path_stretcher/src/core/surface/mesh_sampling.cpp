// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <pcl/conversions.h>

#include <algorithm>
#include <cmath>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "surface/complete_surface.h"
#include "surface/mesh_repair.h"
#include "surface/mesh_topology.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::UnusableInput;

constexpr double kFewestSamples = 20000;  // as many as are compared, see Samples::most; chosen
constexpr double kMaxSamples = 100000;    // chosen

/// Splits polygons into fans of triangles and merges coincident vertices, which STL repeats.
std::vector<Triangle> triangles_of(const pcl::PolygonMesh& mesh, const Points& vertices,
                                   const std::string& name) {
  std::vector<std::uint32_t> order(vertices.size());
  for (std::uint32_t i = 0; i < order.size(); ++i)
    order[i] = i;
  const auto before = [&vertices](std::uint32_t a, std::uint32_t b) {
    return std::lexicographical_compare(vertices[a].begin(), vertices[a].end(), vertices[b].begin(),
                                        vertices[b].end());
  };
  std::stable_sort(order.begin(), order.end(), before);
  std::vector<std::uint32_t> merged(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    merged[order[i]] = same ? merged[order[i - 1]] : order[i];
  }
  std::vector<Triangle> triangles;
  for (const pcl::Vertices& polygon : mesh.polygons) {
    for (const auto vertex : polygon.vertices) {
      if (static_cast<std::size_t>(vertex) >= vertices.size()) {
        throw UnusableInput(
            name,
            fmt::format("a triangle refers to vertex {}, which the mesh does not have", vertex),
            "export the part again");
      }
    }
    for (std::size_t i = 2; i < polygon.vertices.size(); ++i) {
      triangles.push_back({merged[polygon.vertices[0]], merged[polygon.vertices[i - 1]],
                           merged[polygon.vertices[i]]});
    }
  }
  return triangles;
}

/// The i-th point of the R2 low-discrepancy sequence (Roberts 2018) folded into a triangle.
Eigen::Vector2d spread_in_triangle(std::size_t i) {
  constexpr double kFirst = 0.7548776662466927;   // 1 / g, with g^3 = g + 1
  constexpr double kSecond = 0.5698402909980532;  // 1 / g^2
  double whole = 0;
  Eigen::Vector2d uv(std::modf(0.5 + kFirst * static_cast<double>(i), &whole),
                     std::modf(0.5 + kSecond * static_cast<double>(i), &whole));
  if (uv.sum() > 1) uv = Eigen::Vector2d::Ones() - uv;
  return uv;
}

/// Samples at equal steps of the summed area: each triangle gets its share, to within one sample.
void sample(const Points& vertices, const std::vector<Triangle>& triangles, double area,
            std::size_t count, Surface& surface) {
  const double step = area / static_cast<double>(count);
  double summed = 0;
  std::size_t taken = 0;
  for (const Triangle& triangle : triangles) {
    const Eigen::Vector3d& a = vertices[triangle[0]];
    const Eigen::Vector3d ab = vertices[triangle[1]] - a;
    const Eigen::Vector3d ac = vertices[triangle[2]] - a;
    const Eigen::Vector3d cross = ab.cross(ac);
    summed += cross.norm() / 2;
    for (; (static_cast<double>(taken) + 0.5) * step < summed && taken < count; ++taken) {
      const Eigen::Vector2d uv = spread_in_triangle(taken);
      surface.points.push_back(a + uv[0] * ab + uv[1] * ac);
      surface.normals.push_back(cross.normalized());
    }
  }
}

}  // namespace

Surface surface_from_mesh(const pcl::PolygonMesh& mesh, const Eigen::Vector3d& leaf,
                          const std::string& name) {
  scan_cell_common::Cloud cloud;
  pcl::fromPCLPointCloud2(mesh.cloud, cloud);
  const Points vertices = to_points(cloud);
  for (const Eigen::Vector3d& vertex : vertices) {
    if (vertex.allFinite()) continue;
    throw UnusableInput(name, "a vertex is not finite", "export the part again");
  }
  const std::vector<Triangle> triangles = repaired(vertices, triangles_of(mesh, vertices, name));
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    area += (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]).norm() / 2;
  }
  if (!(area > 0)) {
    throw UnusableInput(name, "its triangles have no area", "export the part again");
  }
  const double wanted = area / (leaf.x() * leaf.y());
  const auto count = static_cast<std::size_t>(std::clamp(wanted, kFewestSamples, kMaxSamples));
  Surface surface;
  sample(vertices, triangles, area, count, surface);
  const MeshTopology topology = topology_of(vertices, triangles, area);
  surface.oriented = topology.oriented;
  surface.closed = topology.closed;
  if (topology.inside_out) {
    for (Eigen::Vector3d& normal : surface.normals)
      normal = -normal;
  }
  complete(surface);
  return surface;
}

}  // namespace tool_path_stretcher
