// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/border/border.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;

struct Side {
  std::uint32_t triangle;
  std::size_t edge;
};

/// The border's edge that begins where this one ends.
Side next_of(const PartMesh& mesh, Side side) {
  Side next = {side.triangle, (side.edge + 1) % 3};
  while (mesh.beside[next.triangle][next.edge] != kNoTriangle) {
    const std::uint32_t other = mesh.beside[next.triangle][next.edge];
    const std::uint32_t begin = mesh.triangles[next.triangle][next.edge];
    const Triangle& corners = mesh.triangles[other];
    const auto at = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), begin) -
                                             corners.begin());
    next = {other, at};
  }
  return next;
}

/// Adds the start of an edge, with the normal on each side of it if they differ.
void add_begin(const PartMesh& mesh, Side before, Side side, double corner_angle, Trace& border) {
  const Vector3d& position = mesh.vertices[mesh.triangles[side.triangle][side.edge]];
  const Vector3d& arriving = mesh.normals[before.triangle][(before.edge + 1) % 3];
  const Vector3d& leaving = mesh.normals[side.triangle][side.edge];
  const bool bends = arriving.dot(leaving) < std::cos(corner_angle);
  if (bends) border.points.push_back({position, arriving, true});
  border.points.push_back({position, leaving, bends});
}

Vector3d twice_area(const Trace& border) {
  Vector3d sum = Vector3d::Zero();
  const Vector3d& origin = border.points.front().position;
  for (std::size_t i = 0; i < border.points.size(); ++i) {
    const Vector3d& next = border.points[(i + 1) % border.points.size()].position;
    sum += (border.points[i].position - origin).cross(next - origin);
  }
  return sum;
}

}  // namespace

std::vector<Trace> borders_of(const PartMesh& mesh, double corner_angle) {
  std::vector<std::array<bool, 3>> known(mesh.triangles.size(), {false, false, false});
  std::vector<Trace> borders;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
      if (mesh.beside[t][edge] != kNoTriangle || known[t][edge]) continue;
      Trace border;
      border.closed = true;
      Side side = {t, edge};
      while (!known[side.triangle][side.edge]) {
        known[side.triangle][side.edge] = true;
        const Side next = next_of(mesh, side);
        add_begin(mesh, side, next, corner_angle, border);
        side = next;
      }
      mark_corners(border, corner_angle);
      borders.push_back(std::move(border));
    }
  }
  return borders;
}

void mark_corners(Trace& border, double corner_angle) {
  auto& points = border.points;
  const std::size_t count = points.size();
  const auto way = [&](std::size_t from, std::size_t step) {
    if (!border.closed && from == (step == 1 ? count - 1 : 0)) return Vector3d(Vector3d::Zero());
    Vector3d result = Vector3d::Zero();  // to the next point in another place
    for (std::size_t i = 1; i < count && result.isZero(); ++i)
      result = points[(from + i * step) % count].position - points[from].position;
    return Vector3d(result.normalized());
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d arriving = -way(i, count - 1), leaving = way(i, 1);
    const bool is_end = arriving.isZero() || leaving.isZero();
    if (!is_end && arriving.dot(leaving) < std::cos(corner_angle)) points[i].corner = true;
  }
}

bool is_hole(const Trace& border) {
  constexpr double kCrack = 1e-6;   // area over squared length; chosen
  constexpr double kEdgeOn = -0.1;  // cosine: around the end of a tube it is neither; chosen
  if (twice_area(border).norm() < kCrack * std::pow(length_of(border), 2)) return true;
  Vector3d normal = Vector3d::Zero();
  for (const TracePoint& point : border.points)
    normal += point.normal;
  return twice_area(border).normalized().dot(normal.normalized()) < kEdgeOn;
}

double width_of(const Trace& border) {
  return 2 * twice_area(border).norm() / length_of(border);
}

}  // namespace part_recipes::path_design
