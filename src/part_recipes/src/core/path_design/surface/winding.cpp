// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/surface/winding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>
#include <utility>

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;

struct EdgeOf {
  std::uint32_t low, high;  // numbers of the vertices
  std::uint32_t triangle;
  std::uint32_t edge;

  bool operator<(const EdgeOf& other) const {
    return std::tie(low, high, triangle, edge) <
           std::tie(other.low, other.high, other.triangle, other.edge);
  }
};

/// Whether two triangles run along the edge between them in the same direction: one of them is
/// wound the wrong way round.
bool against_each_other(const Triangle& one, std::size_t edge, const Triangle& other) {
  for (std::size_t i = 0; i < 3; ++i)
    if (other[i] == one[edge] && other[(i + 1) % 3] == one[(edge + 1) % 3]) return true;
  return false;
}

void turn(Triangle& triangle, std::array<std::uint32_t, 3>& beside) {
  std::swap(triangle[1], triangle[2]);
  std::swap(beside[0], beside[2]);
}

/// Follows the neighbours from a triangle on, and winds them like it.
/// @return the triangles of its shell
std::vector<std::uint32_t> spread(PartMesh& mesh, std::uint32_t start, std::vector<bool>& known) {
  std::vector<std::uint32_t> shell = {start};
  known[start] = true;
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const std::uint32_t now = shell[i];
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const std::uint32_t next = mesh.beside[now][edge];
      if (next == kNoTriangle || known[next]) continue;
      known[next] = true;
      if (against_each_other(mesh.triangles[now], edge, mesh.triangles[next]))
        turn(mesh.triangles[next], mesh.beside[next]);
      shell.push_back(next);
    }
  }
  return shell;
}

/// Whether the shell must be turned over: the volume that it encloses is below 0, or it encloses
/// none and faces away from the viewer.
bool is_inside_out(const PartMesh& mesh, const std::vector<std::uint32_t>& shell,
                   const Vector3d& towards) {
  constexpr double kClosed = 0.02;  // of the area: the normals of a closed shell cancel out; chosen
  Vector3d middle = Vector3d::Zero(), facing = Vector3d::Zero();
  double area = 0;
  for (const std::uint32_t t : shell) {
    const auto& [i, j, k] = mesh.triangles[t];
    const Vector3d &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
    const Vector3d cross = (b - a).cross(c - a);
    facing += cross;
    area += cross.norm();
    middle += cross.norm() * (a + b + c) / 3;
  }
  middle /= area;
  if (facing.norm() > kClosed * area) return facing.dot(towards) < 0;
  double enclosed = 0;
  for (const std::uint32_t t : shell) {
    const auto& [i, j, k] = mesh.triangles[t];
    enclosed += (mesh.vertices[i] - middle)
                    .dot((mesh.vertices[j] - middle).cross(mesh.vertices[k] - middle));
  }
  return enclosed < 0;
}

/// A strip with half a twist has two neighbours that no winding reconciles: they are separated.
void part_twisted(PartMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const std::uint32_t other = mesh.beside[t][edge];
      if (other == kNoTriangle ||
          !against_each_other(mesh.triangles[t], edge, mesh.triangles[other]))
        continue;
      std::replace(mesh.beside[other].begin(), mesh.beside[other].end(),
                   static_cast<std::uint32_t>(t), kNoTriangle);
      mesh.beside[t][edge] = kNoTriangle;
    }
  }
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> neighbours_of(const std::vector<Triangle>& triangles) {
  std::vector<EdgeOf> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t edge = 0; edge < 3; ++edge) {
      const auto [low, high] = std::minmax(triangles[t][edge], triangles[t][(edge + 1) % 3]);
      edges.push_back({low, high, t, edge});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<std::uint32_t, 3>> beside(triangles.size(),
                                                   {kNoTriangle, kNoTriangle, kNoTriangle});
  for (auto begin = edges.begin(); begin != edges.end();) {
    const auto end = std::find_if(begin, edges.end(), [begin](const EdgeOf& edge) {
      return edge.low != begin->low || edge.high != begin->high;
    });
    if (end - begin == 2) {
      beside[begin->triangle][begin->edge] = (begin + 1)->triangle;
      beside[(begin + 1)->triangle][(begin + 1)->edge] = begin->triangle;
    }
    begin = end;
  }
  return beside;
}

void wind_alike(PartMesh& mesh, const Vector3d& towards) {
  mesh.beside = neighbours_of(mesh.triangles);
  std::vector<bool> known(mesh.triangles.size(), false);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (known[t]) continue;
    const std::vector<std::uint32_t> shell = spread(mesh, t, known);
    if (!is_inside_out(mesh, shell, towards)) continue;
    for (const std::uint32_t each : shell)
      turn(mesh.triangles[each], mesh.beside[each]);
  }
  part_twisted(mesh);
}

std::vector<std::uint32_t> shells_of(const PartMesh& mesh) {
  std::vector<std::uint32_t> shells(mesh.triangles.size(), kNoTriangle);
  std::uint32_t count = 0;
  for (std::uint32_t start = 0; start < mesh.triangles.size(); ++start) {
    if (shells[start] != kNoTriangle) continue;
    std::vector<std::uint32_t> reached = {start};
    shells[start] = count;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (const std::uint32_t next : mesh.beside[reached[i]]) {
        if (next == kNoTriangle || shells[next] != kNoTriangle) continue;
        shells[next] = count;
        reached.push_back(next);
      }
    }
    ++count;
  }
  return shells;
}

}  // namespace part_recipes::path_design
