// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_demo/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_sim/ground_truth.h"
#include "scan_cell_sim/tool_paths.h"
#include "scan_cell_sim/world.h"

namespace scan_cell_demo {

using tool_path_stretcher::ToolPath;
using tool_path_stretcher::Waypoint;

namespace {

std::vector<const Waypoint*> waypoints(const ToolPath& path) {
  std::vector<const Waypoint*> all;
  for (const auto& segment : path.segments) {
    for (const Waypoint& waypoint : segment.waypoints)
      all.push_back(&waypoint);
  }
  return all;
}

}  // namespace

PathError compare(const ToolPath& path, const ToolPath& truth) {
  const auto ours = waypoints(path);
  const auto theirs = waypoints(truth);
  if (ours.size() != theirs.size() || ours.empty()) {
    throw scan_cell_common::UnusableInput(
        "adapted path", fmt::format("{} waypoints", ours.size()),
        fmt::format("compare it with a path of as many waypoints, not {}", theirs.size()));
  }
  PathError error;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const Eigen::Isometry3d difference = theirs[i]->pose.inverse() * ours[i]->pose;
    const double distance = difference.translation().norm();
    const double angle = Eigen::AngleAxisd(difference.linear()).angle();
    error.rms += distance * distance;
    error.max = std::max(error.max, distance);
    error.orientation_rms += angle * angle;
  }
  const auto count = static_cast<double>(ours.size());
  error.rms = std::sqrt(error.rms / count);
  error.orientation_rms = std::sqrt(error.orientation_rms / count);
  return error;
}

namespace {

/// Distances of waypoints from the nearest of others; of the orientation only the tool's axis
/// counts.
PathError off_nearest(const std::vector<const Waypoint*>& from,
                      const std::vector<const Waypoint*>& to) {
  PathError error;
  for (const Waypoint* each : from) {
    const auto distance = [each](const Waypoint* other) {
      return (other->pose.translation() - each->pose.translation()).norm();
    };
    const Waypoint* nearest =
        *std::min_element(to.begin(), to.end(), [&](const Waypoint* one, const Waypoint* other) {
          return distance(one) < distance(other);
        });
    const Eigen::Vector3d ours = each->pose.linear().col(2);
    const Eigen::Vector3d theirs = nearest->pose.linear().col(2);
    error.rms += distance(nearest) * distance(nearest);
    error.max = std::max(error.max, distance(nearest));
    error.orientation_rms += std::pow(std::atan2(ours.cross(theirs).norm(), ours.dot(theirs)), 2);
  }
  const auto count = static_cast<double>(from.size());
  error.rms = std::sqrt(error.rms / count);
  error.orientation_rms = std::sqrt(error.orientation_rms / count);
  return error;
}

}  // namespace

PathError compare_lines(const ToolPath& path, const ToolPath& truth) {
  const PathError ours = off_nearest(waypoints(path), waypoints(truth));
  const PathError theirs = off_nearest(waypoints(truth), waypoints(path));
  return {std::max(ours.rms, theirs.rms), std::max(ours.max, theirs.max),
          std::max(ours.orientation_rms, theirs.orientation_rms)};
}

namespace {

double distance_to_line(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                        const Eigen::Vector3d& to) {
  const Eigen::Vector3d line = to - from;
  const double share = line.dot(point - from) / std::max(line.squaredNorm(), 1e-30);
  return (from + std::clamp(share, 0.0, 1.0) * line - point).norm();
}

}  // namespace

PathError compare_way(const std::vector<Eigen::Vector3d>& way, const ToolPath& truth) {
  const auto places = waypoints(truth);
  if (way.empty() || places.empty())
    throw scan_cell_common::UnusableInput(
        "recorded path of the tip",
        fmt::format("{} places, {} waypoints", way.size(), places.size()),
        "record it while the robot follows the path");
  PathError error;
  for (const Waypoint* waypoint : places) {
    const Eigen::Vector3d at = waypoint->pose.translation();
    double nearest = (way.front() - at).norm();
    for (std::size_t i = 1; i < way.size(); ++i)
      nearest = std::min(nearest, distance_to_line(at, way[i - 1], way[i]));
    error.rms += nearest * nearest;
    error.max = std::max(error.max, nearest);
  }
  error.rms = std::sqrt(error.rms / static_cast<double>(places.size()));
  return error;
}

ToolPath true_path(const ToolPath& path, const std::string& reference, const std::string& object,
                   const std::string& part) {
  const scan_cell_sim::World from = scan_cell_sim::load_world(reference);
  const scan_cell_sim::World to = scan_cell_sim::load_world(object);
  ToolPath truth = path;
  for (auto& segment : truth.segments) {
    for (Waypoint& waypoint : segment.waypoints) {
      waypoint.pose = scan_cell_sim::true_image(from.part(part), to.part(part), waypoint.pose);
    }
  }
  return truth;
}

ToolPath proven_path(const std::string& world, const std::string& part) {
  constexpr double kSpacing = 2e-3;  // [m]
  const scan_cell_sim::World cell = scan_cell_sim::load_world(world);
  ToolPath path;
  path.name = "path on " + part;
  path.has_orientation = true;
  path.segments.push_back({"path", {}});
  for (const Eigen::Isometry3d& pose : scan_cell_sim::taught_path(cell.part(part), kSpacing)) {
    path.segments.front().waypoints.push_back({pose, {}});
  }
  return path;
}

scan_cell_sim::CloudError cloud_error(const scan_cell_common::Cloud& cloud,
                                      const std::string& world) {
  const scan_cell_sim::Scene truth(scan_cell_sim::load_world(world));
  std::vector<Eigen::Vector3d> points;
  points.reserve(cloud.size());
  for (const pcl::PointXYZ& point : cloud)
    points.emplace_back(point.x, point.y, point.z);
  return scan_cell_sim::compare(truth, points);
}

double true_scale(const std::string& reference, const std::string& object,
                  const std::string& part) {
  return scan_cell_sim::load_world(object).part(part).scale /
         scan_cell_sim::load_world(reference).part(part).scale;
}

}  // namespace scan_cell_demo
