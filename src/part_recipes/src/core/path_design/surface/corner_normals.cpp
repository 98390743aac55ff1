// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/surface/corner_normals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;

std::size_t corner_at(const Triangle& triangle, std::uint32_t vertex) {
  return static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), vertex) -
                                  triangle.begin());
}

/// The facets around a corner, up to sharp edges or the border.
struct Fan {
  std::vector<std::uint32_t> triangles;
  bool all_around = false;
  std::array<Vector3d, 2> ends;  // [m] ways to the other ends of its first and last edge
};

class FanNormals {
 public:
  FanNormals(PartMesh& mesh, double crease_angle)
      : mesh_(mesh), crease_(std::cos(crease_angle)), most_(std::sin(crease_angle / 2)) {}

  void compute() {
    const std::size_t count = mesh_.triangles.size();
    mesh_.normals.resize(count);
    all_around_.resize(count);
    for (std::uint32_t t = 0; t < count; ++t) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Fan fan = fan_at(t, corner);
        all_around_[t][corner] = fan.all_around;
        mesh_.normals[t][corner] = mean(fan, mesh_.triangles[t][corner]);
      }
    }
    const std::vector<CornerNormals> means = mesh_.normals;
    for (std::uint32_t t = 0; t < count; ++t)
      for (std::size_t corner = 0; corner < 3; ++corner)
        if (!all_around_[t][corner])
          mesh_.normals[t][corner] = continued(fan_at(t, corner), t, corner, means);
  }

 private:
  Vector3d way(std::uint32_t from, std::uint32_t to) const {
    return mesh_.vertices[to] - mesh_.vertices[from];
  }

  double angle_at(std::uint32_t triangle, std::uint32_t vertex) const {
    const Triangle& corners = mesh_.triangles[triangle];
    const std::size_t corner = corner_at(corners, vertex);
    const Vector3d one = way(vertex, corners[(corner + 1) % 3]);
    const Vector3d other = way(vertex, corners[(corner + 2) % 3]);
    return std::atan2(one.cross(other).norm(), one.dot(other));
  }

  /// Adds the facets on one side of the first.
  /// @param leave edge by which a triangle is left, counted from its corner at the vertex: 0 or 2
  void go_around(std::uint32_t vertex, std::size_t leave, Fan& fan) const {
    const std::uint32_t start = fan.triangles.front();
    std::uint32_t now = start;
    for (;;) {
      const Triangle& corners = mesh_.triangles[now];
      const std::size_t corner = corner_at(corners, vertex), edge = (corner + leave) % 3;
      const std::uint32_t next = mesh_.beside[now][edge];
      fan.all_around = next == start;
      if (fan.all_around) return;
      if (next == kNoTriangle || bend_at(mesh_, now, edge) < crease_) {
        fan.ends[leave / 2] = way(vertex, corners[(corner + (leave == 0 ? 1 : 2)) % 3]);
        return;
      }
      fan.triangles.push_back(next);
      now = next;
    }
  }

  Fan fan_at(std::uint32_t triangle, std::size_t corner) const {
    Fan fan;
    fan.triangles = {triangle};
    const std::uint32_t vertex = mesh_.triangles[triangle][corner];
    go_around(vertex, 2, fan);
    if (!fan.all_around) go_around(vertex, 0, fan);
    return fan;
  }

  Vector3d mean(const Fan& fan, std::uint32_t vertex) const {
    Vector3d sum = Vector3d::Zero();
    for (const std::uint32_t triangle : fan.triangles)
      sum += angle_at(triangle, vertex) * mesh_.facets[triangle];
    return sum.normalized();
  }

  /// The mean normal, turned further as it turns inside the face. Along the end of the face, the
  /// facets on both sides of a corner balance: only the turn across it counts.
  Vector3d continued(const Fan& fan, std::uint32_t t, std::size_t corner,
                     const std::vector<CornerNormals>& means) const {
    const std::uint32_t vertex = mesh_.triangles[t][corner];
    Vector3d turn = Vector3d::Zero();
    double weights = 0;
    for (const std::uint32_t triangle : fan.triangles) {
      Vector3d inside = Vector3d::Zero();
      for (std::size_t i = 0; i < 3; ++i)
        if (all_around_[triangle][i]) inside += means[triangle][i];
      if (inside.isZero()) continue;
      const double weight = angle_at(triangle, vertex);
      turn += weight * (mesh_.facets[triangle] - inside.normalized());
      weights += weight;
    }
    const Vector3d& leaning = means[t][corner];
    if (weights == 0) return leaning;
    turn /= weights;
    const Vector3d along = (fan.ends[0].normalized() - fan.ends[1].normalized()).normalized();
    turn -= turn.dot(along) * along;
    return turn.norm() > most_ ? leaning : Vector3d((leaning + turn).normalized());
  }

  PartMesh& mesh_;
  const double crease_;  // cosine
  const double most_;    // sine of the widest turn
  std::vector<std::array<bool, 3>> all_around_;
};

}  // namespace

void compute_corner_normals(PartMesh& mesh, double crease_angle) {
  FanNormals(mesh, crease_angle).compute();
}

}  // namespace part_recipes::path_design
