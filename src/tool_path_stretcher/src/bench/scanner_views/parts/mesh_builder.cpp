// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/parts/mesh_builder.h"

#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include "tool_path_stretcher/surface.h"

namespace scanner_views {
namespace {

using Eigen::Vector3d;

/// Adds the triangle, or those that result from halving its long edges. Both triangles at an edge
/// halve it in the same way, so no gap opens.
void halve(const std::array<Vector3d, 3>& corner, double longest, std::vector<Vector3d>& result) {
  std::array<bool, 3> is_long{};
  std::array<Vector3d, 3> middle;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d &from = corner[i], &to = corner[(i + 1) % 3];
    is_long[i] = (from - to).norm() > longest;
    middle[i] = (from + to) / 2;
  }
  const auto add = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    halve({a, b, c}, longest, result);
  };
  const auto& [a, b, c] = corner;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d &from = corner[i], &to = corner[(i + 1) % 3], &apex = corner[(i + 2) % 3];
    const bool next = is_long[(i + 1) % 3], last = is_long[(i + 2) % 3];
    if (is_long[i] && !next && !last) {
      add(from, middle[i], apex);
      add(middle[i], to, apex);
      return;
    }
    if (is_long[i] && next && !last) {
      const Vector3d& other = middle[(i + 1) % 3];
      add(middle[i], to, other);
      add(from, middle[i], other);
      add(from, other, apex);
      return;
    }
  }
  if (is_long[0]) {
    add(a, middle[0], middle[2]);
    add(middle[0], b, middle[1]);
    add(middle[2], middle[1], c);
    add(middle[0], middle[1], middle[2]);
    return;
  }
  result.insert(result.end(), corner.begin(), corner.end());
}

}  // namespace

void MeshBuilder::triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  constexpr double kNone = 1e-12;  // [m^2] 1 um on each side
  if ((b - a).cross(c - a).norm() < kNone) return;
  const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
  mesh_.vertices.insert(mesh_.vertices.end(), {a, b, c});
  mesh_.triangles.push_back({first, first + 1, first + 2});
}

void MeshBuilder::quad(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  triangle(a, b, c);
  triangle(a, c, d);
}

void MeshBuilder::band(const Points& from, const Points& to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::size_t next = (i + 1) % from.size();
    quad(from[i], from[next], to.at(next), to.at(i));
  }
}

Mesh refined(const Mesh& mesh, double longest) {
  std::vector<Vector3d> corners;
  for (const auto& [a, b, c] : mesh.triangles)
    halve({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, longest, corners);
  Mesh result;
  result.vertices = std::move(corners);
  for (std::uint32_t i = 0; i < result.vertices.size(); i += 3)
    result.triangles.push_back({i, i + 1, i + 2});
  return result;
}

Eigen::AlignedBox3d box_of(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& vertex : mesh.vertices)
    box.extend(vertex);
  return box;
}

double volume_of(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += mesh.vertices[a].cross(mesh.vertices[b]).dot(mesh.vertices[c]) / 6;
  return sum;
}

pcl::PolygonMesh to_polygon_mesh(const Mesh& mesh) {
  pcl::PointCloud<pcl::PointXYZ> vertices;
  for (const Vector3d& vertex : mesh.vertices) {
    const Eigen::Vector3f at = vertex.cast<float>();
    vertices.push_back({at.x(), at.y(), at.z()});
  }
  pcl::PolygonMesh result;
  pcl::toPCLPointCloud2(vertices, result.cloud);
  for (const auto& triangle : mesh.triangles) {
    result.polygons.emplace_back();
    for (const std::uint32_t corner : triangle)
      result.polygons.back().vertices.push_back(static_cast<pcl::index_t>(corner));
  }
  return result;
}

Mesh from_polygon_mesh(const pcl::PolygonMesh& mesh) {
  pcl::PointCloud<pcl::PointXYZ> vertices;
  pcl::fromPCLPointCloud2(mesh.cloud, vertices);
  const Points points = tool_path_stretcher::to_points(vertices);
  MeshBuilder builder;
  for (const pcl::Vertices& face : mesh.polygons) {
    const auto corner = [&](std::size_t i) {
      return points.at(static_cast<std::size_t>(face.vertices.at(i)));
    };
    builder.triangle(corner(0), corner(1), corner(2));
  }
  return builder.take();
}

}  // namespace scanner_views
