// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/report/cleaned_away.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

#include "deviation/deviations.h"
#include "run/calls/recipe_reading.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/geometry/point_tree.h"
#include "scan_cell_common/pose/units.h"
#include "tool_path_stretcher/reported_verdict.h"
#include "tool_path_stretcher/surface.h"

namespace part_recipes {
namespace {

using scan_cell_common::PointTree;

bool has_near(const PointTree& tree, const Eigen::Vector3d& place, double near) {
  PointTree::Index index = 0;
  double squared = near * near;
  const double before = squared;
  tree.nearest_within(place.data(), index, squared);
  return squared < before;
}

/// The points of the cloud that can be near: a scan has millions, and most belong to other places.
Points around(const Points& places, const Points& cloud, double near) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& place : places)
    box.extend(place);
  box.extend(box.min() - Eigen::Vector3d::Constant(near));
  box.extend(box.max() + Eigen::Vector3d::Constant(near));
  Points found;
  std::copy_if(
      cloud.begin(), cloud.end(), std::back_inserter(found),
      [&box](const Eigen::Vector3d& point) { return point.allFinite() && box.contains(point); });
  return found;
}

/// The nearest points of the reference, moved by the part's pose: a path may run above the surface.
Points surface_beside(const Points& waypoints, const Points& reference,
                      const tool_path_stretcher::Similarity& similarity) {
  const PointTree tree(reference);
  Points places;
  for (const Eigen::Vector3d& waypoint : waypoints) {
    PointTree::Index index = 0;
    double squared = 0;
    tree.nearest(waypoint.data(), 1, &index, &squared);
    places.push_back(similarity * reference[index]);
  }
  return places;
}

/// [m] Distance at which a point of a scan counts as at a place: a place between the scan's points
/// may be nearly one spacing from each.
/// @param scanned points around the places
double reach_of_scan(const Points& scanned, double near) {
  constexpr std::size_t kEnough = 20;  // for spacing_of()
  return scanned.size() < kEnough ? near : std::max(near, spacing_of(scanned));
}

Points load_points(const std::filesystem::path& file, double metres_per_unit) {
  return tool_path_stretcher::to_points(
      scan_cell_common::load_cloud(file.string(), metres_per_unit));
}

}  // namespace

std::vector<std::size_t> cleaned_away(const Points& places, const Points& raw, const Points& clean,
                                      double near) {
  constexpr double kSpacings = 2;  // the grid's cells are wider than the scan's spacing; chosen
  constexpr double kAround = 4;    // as far, so that the spacing is that of a region; chosen
  if (places.empty()) return {};
  const double bare = std::max(near, kSpacings * spacing_of(clean));
  const Points scanned = around(places, raw, kAround * bare);
  if (scanned.empty()) return {};
  const double there = std::min(bare, reach_of_scan(scanned, near));
  const PointTree before(scanned);
  const PointTree after(clean);
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (has_near(before, places[i], there) && !has_near(after, places[i], bare)) taken.push_back(i);
  return taken;
}

std::vector<std::size_t> waypoints_cleaned_away(const Recipe& recipe, const RefusedRun& run) {
  const auto verdict = tool_path_stretcher::load_report(run.report.string());
  if (verdict.similarities.empty() || verdict.waypoints.empty()) return {};
  const Points all = positions_of(
      load_path((run.inputs / recipe.path.file).string(), reading_of(recipe.path)).path);
  const auto parameters = stretch_parameters_of(recipe);
  const auto last = std::max_element(verdict.waypoints.begin(), verdict.waypoints.end());
  if (parameters.resample_spacing > 0 || *last >= all.size()) return {};
  Points waypoints;
  for (const std::size_t waypoint : verdict.waypoints)
    waypoints.push_back(all[waypoint]);
  const auto reference = tool_path_stretcher::load_surface(
      (run.inputs / recipe.reference.file).string(), parameters.leaf,
      scan_cell_common::metres_per(recipe.reference.units));
  const auto taken =
      cleaned_away(surface_beside(waypoints, reference.points, verdict.similarities.front()),
                   load_points(run.scan, scan_cell_common::metres_per(run.scan_units)),
                   load_points(run.clean, 1), parameters.tolerance);
  std::vector<std::size_t> numbers;
  for (const std::size_t i : taken)
    numbers.push_back(verdict.waypoints[i]);
  return numbers;
}

}  // namespace part_recipes
