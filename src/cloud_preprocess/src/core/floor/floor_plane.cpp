// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "floor/floor_plane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "floor/sample_shares.h"
#include "geometry/clusters.h"

namespace cloud_preprocess {
namespace {

/// Points where the surface is level. Otherwise the walls of a box would look like a stack of thin
/// floors.
OrientedPoints level_points(const OrientedPoints& points, double tilt) {
  constexpr double kNoise = 0.25;  // [rad] of a normal from few points; chosen
  const double min_z = std::cos(tilt + kNoise);
  std::vector<Eigen::Index> level;
  for (Eigen::Index i = 0; i < points.points.cols(); ++i) {
    if (std::abs(points.normals(2, i)) >= min_z) level.push_back(i);
  }
  return points.only(level);
}

/// The range of the points along an axis, without the outermost few.
std::array<double, 2> extent(const OrientedPoints& points, Eigen::Index axis) {
  constexpr double kOutermost = 0.005;  // of the points, at either end; chosen
  std::vector<double> values(points.points.row(axis).begin(), points.points.row(axis).end());
  std::sort(values.begin(), values.end());
  const auto skip = static_cast<std::size_t>(kOutermost * static_cast<double>(values.size()));
  return {values[skip], values[values.size() - 1 - skip]};
}

/// Whether a plane comes near the edge of the scan on any side. A flat face inside a frame does
/// not.
bool reaches_edge(const OrientedPoints& part, const OrientedPoints& whole) {
  constexpr double kNear = 0.02;  // of the whole's extent; chosen
  for (const Eigen::Index axis : {0, 1}) {
    const auto [part_least, part_most] = extent(part, axis);
    const auto [least, most] = extent(whole, axis);
    const double near = kNear * (most - least);
    if (part_least <= least + near || part_most >= most - near) return true;
  }
  return false;
}

OrientedPoints points_below(const OrientedPoints& points, const Plane& plane, double distance) {
  std::vector<Eigen::Index> below;
  for (Eigen::Index i = 0; i < points.points.cols(); ++i) {
    if (plane.height(Eigen::Vector3d(points.points.col(i))) < -distance) below.push_back(i);
  }
  return points.only(below);
}

/// The floor of a sample with z up.
std::optional<Floor> find_level_floor(const OrientedPoints& sample,
                                      const FloorParameters& parameters) {
  const std::size_t min_points = min_points_of(sample, parameters);
  OrientedPoints candidates = level_points(sample, parameters.tilt);
  const PlaneSearch search{parameters.distance, Eigen::Vector3d::UnitZ(), parameters.tilt};
  while (candidates.size() >= min_points) {
    const auto found = largest_plane(candidates, search);
    if (!found || found->inliers.size() < min_points) break;
    const double distance = parameters.distance;
    const std::size_t below = points_below(sample, found->plane, distance).size();
    if (below <= share_of(sample, parameters.max_below)) {
      if (!reaches_edge(candidates.only(found->inliers), sample)) break;
      return Floor{found->plane, found->inliers.size()};
    }
    candidates = points_below(candidates, found->plane, distance);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Floor> find_floor(const OrientedPoints& sample, const Eigen::Vector3d& up,
                                const FloorParameters& parameters) {
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  if (up == z) return find_level_floor(sample, parameters);
  const Eigen::Matrix3d to_level = Eigen::Quaterniond::FromTwoVectors(up, z).toRotationMatrix();
  const OrientedPoints level{to_level * sample.points, to_level * sample.normals, sample.spacing};
  std::optional<Floor> floor = find_level_floor(level, parameters);
  if (floor) {
    floor->plane.point = to_level.transpose() * floor->plane.point;
    floor->plane.normal = to_level.transpose() * floor->plane.normal;
  }
  return floor;
}

std::vector<std::size_t> find_objects(const OrientedPoints& sample,
                                      const FloorParameters& parameters) {
  constexpr double kGap = 0.01;    // [m] chosen
  constexpr double kSpacings = 5;  // nearer clusters cannot be told apart; chosen
  Cloud cloud;
  for (const auto& point : sample.points.colwise()) {
    const Eigen::Vector3f place = point.cast<float>();
    cloud.push_back({place.x(), place.y(), place.z()});
  }
  std::vector<std::size_t> sizes;
  for (const auto& cluster : clusters(cloud, std::max(kGap, kSpacings * sample.spacing))) {
    if (cluster.size() >= min_points_of(sample, parameters)) sizes.push_back(cluster.size());
  }
  std::sort(sizes.rbegin(), sizes.rend());
  return sizes;
}

}  // namespace cloud_preprocess
