// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

#include "measurements.h"
#include "pass_planner/sight.h"

namespace pass_planner {
namespace {

using Eigen::Vector3d;

constexpr double kSpacing = 1.5e-3;  // [m] of the places, chosen: as kThere

/// Divides a triangle into small equal ones; their middles are places.
void divide(const std::array<Vector3d, 3>& corners, std::vector<Surface::Place>& places) {
  const Vector3d across = corners[1] - corners[0], along = corners[2] - corners[0];
  const Vector3d normal = across.cross(along);
  if (!(normal.norm() > 0)) return;
  const double longest = std::max({across.norm(), along.norm(), (corners[2] - corners[1]).norm()});
  const int parts = std::max(1, static_cast<int>(std::ceil(longest / kSpacing)));
  const auto add = [&](double u, double v) {
    places.push_back({corners[0] + u / parts * across + v / parts * along, normal.normalized(), 0});
  };
  for (int i = 0; i < parts; ++i) {
    for (int j = 0; i + j < parts; ++j) {
      add(i + 1. / 3, j + 1. / 3);
      if (i + j + 1 < parts) add(i + 2. / 3, j + 2. / 3);
    }
  }
}

/// Keeps one place in each cube of that size: thin triangles would count too often.
std::vector<Surface::Place> thinned(const std::vector<Surface::Place>& places) {
  std::set<std::array<long, 3>> taken;
  std::vector<Surface::Place> result;
  for (const Surface::Place& place : places) {
    const Vector3d cube = place.point / kSpacing;
    const auto cell = [&](int axis) { return std::lround(std::floor(cube[axis])); };
    if (taken.insert({cell(0), cell(1), cell(2)}).second) result.push_back(place);
  }
  return result;
}

}  // namespace

double Coverage::share(double max_angle) const {
  std::size_t places = 0, there = 0;
  for (const AngleCoverage& one : by_angle) {
    if (one.max_angle > max_angle + 1e-9) break;
    places += one.places;
    there += one.there;
  }
  return places == 0 ? 1 : static_cast<double>(there) / static_cast<double>(places);
}

Coverage measure_coverage(const scan_cell_sim::World& world,
                          const std::vector<scan_cell::ScanPass>& passes,
                          const scan_cell_common::ScannerModel& scanner,
                          const std::vector<Vector3d>& cloud) {
  SurfaceShape shape;
  std::vector<Surface::Place> all;
  const scan_cell_sim::Scene parts({std::nullopt, std::nullopt, world.parts});
  for (const scan_cell_sim::Mesh& mesh : parts.meshes()) {
    const auto first = static_cast<std::uint32_t>(shape.points.size());
    shape.points.insert(shape.points.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const auto& [a, b, c] : mesh.triangles) {
      shape.triangles.push_back({first + a, first + b, first + c});
      divide({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, all);
    }
  }
  const Surface surface(shape);
  const std::vector<Surface::Place> places = thinned(all);
  const SightCheck check(scanner, surface, any_angle_in_the_cell());
  const PathSight sight = look_along(check, sweeps_of(passes), places);

  Coverage result;
  for (const int degrees : {60, 70, 74, 78, 82, 86, 90})
    result.by_angle.push_back({degrees * M_PI / 180, 0, 0});
  std::vector<Vector3d> points;
  for (const Surface::Place& place : places)
    points.push_back(place.point);
  const std::vector<double> off = distances(points, cloud);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Sighting& best = sight.best[i];
    if (best.sight != Sight::kSeen) continue;
    const double angle = std::max(best.light_angle, best.sight_angle);
    const auto entry =
        std::find_if(result.by_angle.begin(), std::prev(result.by_angle.end()),
                     [angle](const AngleCoverage& one) { return angle <= one.max_angle; });
    ++entry->places;
    entry->there += off[i] <= kThere;
  }
  result.error = scan_cell_sim::compare(scan_cell_sim::Scene(world), cloud);
  return result;
}

}  // namespace pass_planner
