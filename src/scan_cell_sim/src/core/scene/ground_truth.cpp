// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/ground_truth.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "scan_cell_common/errors/errors.h"
#include "scene/scramble.h"

namespace scan_cell_sim {
namespace {

using Eigen::Vector3d;
using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;

struct Triangle {
  Vector3d a, b, c;
  Vector3d area_normal() const { return (b - a).cross(c - a) / 2; }
};

/// Triangles that face upwards, without steep ones, which are not visible from above.
std::vector<Triangle> upper_triangles(const Scene& scene) {
  constexpr double kSteepest = 0.05;  // cosine to the vertical; chosen
  std::vector<Triangle> result;
  for (const Mesh& mesh : scene.meshes()) {
    for (const auto& corner : mesh.triangles) {
      const Triangle triangle{mesh.vertices[corner[0]], mesh.vertices[corner[1]],
                              mesh.vertices[corner[2]]};
      const Vector3d normal = triangle.area_normal();
      if (normal.z() > kSteepest * normal.norm()) result.push_back(triangle);
    }
  }
  return result;
}

/// Uniform in 0 .. 1; std::uniform_real_distribution may differ between libraries.
double uniform(std::mt19937_64& random) {
  return to_unit(random());
}

/// Standard normal (Box and Muller 1958).
double normal(std::mt19937_64& random) {
  const double radius = std::sqrt(-2 * std::log(1 - uniform(random)));
  return radius * std::cos(2 * M_PI * uniform(random));
}

Vector3d point_in(const Triangle& triangle, std::mt19937_64& random) {
  double u = uniform(random), v = uniform(random);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  return triangle.a + u * (triangle.b - triangle.a) + v * (triangle.c - triangle.a);
}

}  // namespace

CloudError compare(const Scene& truth, const std::vector<Vector3d>& points) {
  if (points.empty()) throw UnusableInput("cloud", "no points", "give a cloud with points");
  CloudError error;
  double squares = 0;
  for (const Vector3d& point : points) {
    if (!point.allFinite()) {
      throw UnusableInput("cloud", "a point that is not finite", "remove such points first");
    }
    const double distance = truth.distance_to_surface(point);
    if (!std::isfinite(distance)) {
      throw UnusableInput("world", "no surface", "give a world with parts or a floor");
    }
    ++error.points;
    error.mean += distance;
    squares += distance * distance;
    error.max = std::max(error.max, distance);
  }
  error.mean /= static_cast<double>(error.points);
  error.rms = std::sqrt(squares / static_cast<double>(error.points));
  return error;
}

std::vector<Vector3d> sample(const Scene& scene, std::size_t count, std::uint64_t seed,
                             double noise) {
  if (count == 0) throw InvalidParameter("points", "0", "ask for at least one");
  if (!(noise >= 0) || !std::isfinite(noise)) {
    throw InvalidParameter("noise", fmt::format("{:g} m", noise), "give 0 or more");
  }
  const std::vector<Triangle> triangles = upper_triangles(scene);
  std::vector<double> area_up_to;
  double area = 0;
  for (const Triangle& triangle : triangles)
    area_up_to.push_back(area += triangle.area_normal().norm());
  if (triangles.empty()) throw UnusableInput("world", "no surface", "give a world with parts");

  constexpr double kSky = 100;  // [m] chosen: above everything
  std::mt19937_64 random(seed);
  std::vector<Vector3d> points;
  points.reserve(count);
  while (points.size() < count) {
    const auto found =
        std::lower_bound(area_up_to.begin(), area_up_to.end(), uniform(random) * area);
    const Triangle& triangle = triangles[static_cast<std::size_t>(found - area_up_to.begin())];
    const Vector3d point = point_in(triangle, random);
    if (!scene.sees(point, point + kSky * Vector3d::UnitZ())) continue;
    points.push_back(point + noise * normal(random) * triangle.area_normal().normalized());
  }
  return points;
}

}  // namespace scan_cell_sim
