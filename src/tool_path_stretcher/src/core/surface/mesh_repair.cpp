// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/mesh_repair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <utility>

#include "surface/mesh_sides.h"

namespace tool_path_stretcher {
namespace {

struct BesideIt {
  std::size_t triangle;
  bool alike;  // both run along their common edge in opposite directions
};

using Neighbours = std::vector<std::vector<BesideIt>>;

/// Removes triangles with two equal corners, and duplicates.
std::vector<Triangle> distinct(const std::vector<Triangle>& triangles) {
  std::set<Triangle> known;
  std::vector<Triangle> kept;
  for (const Triangle& triangle : triangles) {
    Triangle corners = triangle;
    std::sort(corners.begin(), corners.end());
    if (corners[0] == corners[1] || corners[1] == corners[2]) continue;
    if (known.insert(corners).second) kept.push_back(triangle);
  }
  return kept;
}

/// Neighbours across edges where two triangles meet.
Neighbours neighbours_of(const std::vector<Triangle>& triangles) {
  Neighbours neighbours(triangles.size());
  for_each_edge(sides_of(triangles), [&neighbours](auto first, auto last) {
    if (last - first != 2) return;
    const Side& one = *first;
    const Side& other = *(first + 1);
    const bool alike = one.forward != other.forward;
    neighbours[one.triangle].push_back({other.triangle, alike});
    neighbours[other.triangle].push_back({one.triangle, alike});
  });
  return neighbours;
}

/// Connected triangles, and which of them are wound opposite to the first.
struct Piece {
  std::vector<std::size_t> triangles;
  std::vector<bool> turned;  // of each triangle
  bool closed = true;        // each triangle has three neighbours
};

Piece piece_from(std::size_t first, const Neighbours& neighbours, std::vector<bool>& taken) {
  Piece piece{{first}, {false}};
  taken[first] = true;
  for (std::size_t i = 0; i < piece.triangles.size(); ++i) {
    const auto& beside = neighbours[piece.triangles[i]];
    piece.closed = piece.closed && beside.size() == 3;
    for (const BesideIt& neighbour : beside) {
      if (taken[neighbour.triangle]) continue;
      taken[neighbour.triangle] = true;
      piece.triangles.push_back(neighbour.triangle);
      piece.turned.push_back(piece.turned[i] == neighbour.alike);
    }
  }
  return piece;
}

/// Below 0 if the piece, wound like its first triangle, should be turned over. If closed: the
/// enclosed volume [m^3]; otherwise: how much more of its area [m^2] is wound this way than the
/// other.
double rightness(const Points& vertices, const std::vector<Triangle>& triangles,
                 const Piece& piece) {
  const Eigen::Vector3d& origin = vertices[triangles[piece.triangles.front()][0]];
  double sum = 0;
  for (std::size_t i = 0; i < piece.triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[piece.triangles[i]];
    const Eigen::Vector3d area = (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]);
    const double each = piece.closed ? (vertices[a] - origin).dot(area) : area.norm();
    sum += piece.turned[i] ? -each : each;
  }
  return sum;
}

}  // namespace

std::vector<Triangle> repaired(const Points& vertices, const std::vector<Triangle>& triangles) {
  std::vector<Triangle> result = distinct(triangles);
  const Neighbours neighbours = neighbours_of(result);
  std::vector<bool> taken(result.size(), false);
  for (std::size_t first = 0; first < taken.size(); ++first) {
    if (taken[first]) continue;
    const Piece piece = piece_from(first, neighbours, taken);
    const bool over = rightness(vertices, result, piece) < 0;
    for (std::size_t i = 0; i < piece.triangles.size(); ++i) {
      Triangle& triangle = result[piece.triangles[i]];
      if (piece.turned[i] != over) std::swap(triangle[1], triangle[2]);
    }
  }
  return result;
}

}  // namespace tool_path_stretcher
