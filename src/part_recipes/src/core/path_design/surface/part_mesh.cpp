// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/surface/part_mesh.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "path_design/surface/corner_normals.h"
#include "path_design/surface/winding.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;
using scan_cell_common::UnusableInput;

void check_finite(const Points& vertices, const std::string& name) {
  const auto bad = std::count_if(vertices.begin(), vertices.end(),
                                 [](const Vector3d& vertex) { return !vertex.allFinite(); });
  if (bad == 0) return;
  throw UnusableInput(
      name, fmt::format("{} of {} vertices are not finite (NaN or infinite)", bad, vertices.size()),
      "export the part again");
}

/// For each vertex, the number of the first vertex in the same place: STL repeats them.
std::vector<std::uint32_t> first_in_place(const Points& vertices) {
  std::vector<std::uint32_t> order(vertices.size());
  for (std::uint32_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::sort(order.begin(), order.end(), [&vertices](std::uint32_t a, std::uint32_t b) {
    const Vector3d &left = vertices[a], &right = vertices[b];
    if (left != right)
      return std::lexicographical_compare(left.begin(), left.end(), right.begin(), right.end());
    return a < b;
  });
  std::vector<std::uint32_t> first(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

Vector3d cross_of(const PartMesh& mesh, const Triangle& triangle) {
  const Vector3d& a = mesh.vertices[triangle[0]];
  return (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
}

/// A triangle that is flatter than single precision can tell has no normal.
bool has_area(const PartMesh& mesh, const Triangle& triangle) {
  constexpr double kFlattest = 1e-6;  // height over base; the resolution of STL's floats is 1e-7
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d edge = mesh.vertices[triangle[(i + 1) % 3]] - mesh.vertices[triangle[i]];
    longest = std::max(longest, edge.squaredNorm());
  }
  return cross_of(mesh, triangle).norm() > kFlattest * longest;
}

void compute_facets(PartMesh& mesh) {
  mesh.facets.clear();
  mesh.facets.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles)
    mesh.facets.push_back(cross_of(mesh, triangle).normalized());
}

}  // namespace

PartMesh joined_mesh(const Points& vertices, const std::vector<Triangle>& triangles,
                     const Vector3d& towards, double crease_angle, const std::string& name) {
  check_finite(vertices, name);
  const std::vector<std::uint32_t> first = first_in_place(vertices);
  PartMesh mesh;
  mesh.vertices = vertices;
  for (Triangle triangle : triangles) {
    for (std::uint32_t& corner : triangle)
      corner = first.at(corner);
    if (has_area(mesh, triangle)) mesh.triangles.push_back(triangle);
  }
  if (mesh.triangles.empty())
    throw UnusableInput(name, "its triangles have no area", "export the part again");
  wind_alike(mesh, towards);
  compute_facets(mesh);
  compute_corner_normals(mesh, crease_angle);
  return mesh;
}

PartMesh mesh_with_normals(const Points& vertices, const Points& vertex_normals,
                           const std::vector<Triangle>& triangles) {
  PartMesh mesh;
  mesh.vertices = vertices;
  mesh.triangles = triangles;
  mesh.beside = neighbours_of(mesh.triangles);
  compute_facets(mesh);
  for (const Triangle& triangle : triangles) {
    mesh.normals.push_back(
        {vertex_normals[triangle[0]], vertex_normals[triangle[1]], vertex_normals[triangle[2]]});
  }
  return mesh;
}

PartMesh part_of(const PartMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  PartMesh part;
  part.vertices = mesh.vertices;
  part.spacing = mesh.spacing;
  std::vector<std::uint32_t> number(mesh.triangles.size(), kNoTriangle);
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    number[triangles[i]] = i;
  for (const std::uint32_t t : triangles) {
    part.triangles.push_back(mesh.triangles[t]);
    part.facets.push_back(mesh.facets[t]);
    part.normals.push_back(mesh.normals[t]);
    auto beside = mesh.beside[t];
    for (std::uint32_t& other : beside)
      if (other != kNoTriangle) other = number[other];
    part.beside.push_back(beside);
  }
  return part;
}

double area_of(const PartMesh& mesh, std::size_t triangle) {
  return cross_of(mesh, mesh.triangles[triangle]).norm() / 2;
}

double bend_at(const PartMesh& mesh, std::size_t triangle, std::size_t edge) {
  const std::uint32_t other = mesh.beside[triangle][edge];
  return other == kNoTriangle ? 1 : mesh.facets[triangle].dot(mesh.facets[other]);
}

}  // namespace part_recipes::path_design
