// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/floor_removal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "floor/floor_plane.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace cloud_preprocess {
namespace {

using scan_cell_common::UnusableInput;

double degrees(double radians) {
  return radians * 180 / M_PI;
}

/// [rad] between two directions of length 1
double angle_between(const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
  return std::acos(std::clamp(one.dot(other), -1.0, 1.0));
}

std::string text_of(const Eigen::Vector3d& vector,
                    const char* numbers = "({:.4g}, {:.4g}, {:.4g})") {
  constexpr double kShown = 5e-5;  // less would be written as -0.0000
  const Eigen::Vector3d clean = (vector.array().abs() < kShown).select(0, vector);
  return fmt::format(fmt::runtime(numbers), clean.x(), clean.y(), clean.z());
}

int percent(std::size_t points, const OrientedPoints& sample) {
  return static_cast<int>(
      std::lround(100 * static_cast<double>(points) / static_cast<double>(sample.size())));
}

/// Whether a limit has cut something off on the floor's side.
bool cuts_floor(const Cloud& cloud, const Limits& limits, const Eigen::Vector3d& up) {
  Eigen::Index axis = 0;
  up.cwiseAbs().maxCoeff(&axis);
  const double least[] = {limits.x_min, limits.y_min, limits.z_min};
  const double most[] = {limits.x_max, limits.y_max, limits.z_max};
  return std::any_of(cloud.begin(), cloud.end(), [&](const pcl::PointXYZ& point) {
    const auto value = static_cast<double>(point.data[axis]);
    return up[axis] > 0 ? value < least[axis] : value > most[axis];
  });
}

constexpr const char* kNoFloorHere =
    "automatic: false (clean_cloud: --floor off) if there is no floor";

[[noreturn]] void refuse_table(const Floor& table, const Eigen::Vector3d& up,
                               const OrientedPoints& sample) {
  const Eigen::Vector3d& found = table.plane.normal;
  throw UnusableInput(
      "up",
      fmt::format("{}, but {:.1f} deg from it a plane of {} % of the points looks like a table",
                  text_of(up), degrees(angle_between(found, up)), percent(table.points, sample)),
      fmt::format("set up: {} (clean_cloud: --up {}, or --up auto) if it is one, or {}",
                  text_of(found, "[{:.4f}, {:.4f}, {:.4f}]"),
                  text_of(found, "{:.4f},{:.4f},{:.4f}"), kNoFloorHere));
}

[[noreturn]] void refuse_objects(const std::vector<std::size_t>& objects,
                                 const OrientedPoints& sample, const FloorParameters& parameters) {
  std::vector<int> shares;
  for (const std::size_t points : objects)
    shares.push_back(percent(points, sample));
  throw UnusableInput(
      "up",
      fmt::format("{}, but no floor is within {:.1f} deg of it, and {} objects stand there ({} % "
                  "of the points)",
                  text_of(parameters.up), degrees(parameters.tilt), objects.size(),
                  fmt::join(shares, ", ")),
      fmt::format("one of them may be the floor: set up, away from it (clean_cloud: --up x,y,z or "
                  "--up auto), a limit that cuts it off, or {}",
                  kNoFloorHere));
}

/// Whether a larger table in another direction shows that the plane found is not the floor. If the
/// table stands on its side, the lowest face of the part looks like a floor.
bool contradicts(const Floor& table, const std::optional<Floor>& floor) {
  constexpr double kOtherDirection = 0.17;  // [rad] 10 degrees; chosen
  return !floor || (angle_between(table.plane.normal, floor->plane.normal) > kOtherDirection &&
                    table.points > floor->points);
}

/// The floor; none if there is none and nothing could be one.
std::optional<Plane> floor_of(const OrientedPoints& sample, const FloorParameters& parameters,
                              bool is_cut) {
  const Eigen::Vector3d up = parameters.up.normalized();
  const std::optional<Floor> table = find_table(sample, parameters);
  if (parameters.any_direction && table) {
    const std::optional<Floor> floor = find_floor(sample, table->plane.normal, parameters);
    return floor ? floor->plane : table->plane;
  }
  const std::optional<Floor> floor = find_floor(sample, up, parameters);
  if (!is_cut && table && contradicts(*table, floor)) refuse_table(*table, up, sample);
  if (floor) return floor->plane;
  if (!is_cut) {
    const std::vector<std::size_t> objects = find_objects(sample, parameters);
    if (objects.size() > 1) refuse_objects(objects, sample, parameters);
  }
  return std::nullopt;
}

}  // namespace

void describe(scan_cell_common::ParameterTable& table, FloorParameters& parameters) {
  table.add("automatic", parameters.automatic, "look for the floor; false: limits only");
  table.add("margin", parameters.margin, {0, 1, "m"},
            "points up to this height above the floor are removed with it");
  table.add("distance", parameters.distance, {1e-5, 0.1, "m"},
            "how far points of the floor may lie from its plane");
  table.add("up", parameters.up, {-1e3, 1e3},
            "direction away from the floor, in the cloud's frame, of any length");
  constexpr double kLeast = 1e-6;
  if (parameters.up.norm() < kLeast)
    table.refuse("up", text_of(parameters.up), "give the direction away from the floor: 0, 0, 1");
  table.add("any_direction", parameters.any_direction,
            "true: look for a table in any direction, and along `up` if there is none");
  table.add("tilt", parameters.tilt, {1e-3, 0.7, "rad"},
            "how far the floor's normal may lean from `up`");
  table.add("min_share", parameters.min_share, {1e-3, 1},
            "share of all points that a floor must have");
  table.renamed("least_share", "min_share");
  table.add("max_below", parameters.max_below, {0, 0.5},
            "share of all points that may lie below a floor");
  table.renamed("most_below", "max_below");
  describe(table, parameters.limits);
}

FloorRemoval::FloorRemoval(const FloorParameters& parameters) : parameters_(parameters) {
  scan_cell_common::check(parameters_);
}

std::string FloorRemoval::apply(TracedCloud& cloud) const {
  const bool is_cut = cuts_floor(cloud.cloud(), parameters_.limits, parameters_.up);
  const std::string message = cut(cloud, parameters_.limits);
  if (!parameters_.automatic) return message + "floor not searched for";

  const OrientedPoints sample = sample_with_normals(cloud.cloud());
  const std::optional<Plane> floor = floor_of(sample, parameters_, is_cut);
  if (!floor) return message + "no floor found";
  SeenFloor seen{{}, floor->point.cast<float>(), floor->normal.cast<float>()};
  const std::size_t removed = cloud.keep_if([&](std::size_t i) {
    const bool is_above = !(floor->height(cloud.cloud()[i]) <= parameters_.margin);
    if (!is_above) seen.points.push_back(cloud.cloud()[i]);
    return is_above;
  });
  if (removed > 0) cloud.set_floor(std::move(seen));
  return fmt::format("{}{} on or below the floor through {} m, which leans {:.2f} deg", message,
                     removed, text_of(floor->point, "({:.4f}, {:.4f}, {:.4f})"),
                     degrees(angle_between(floor->normal, parameters_.up.normalized())));
}

}  // namespace cloud_preprocess
