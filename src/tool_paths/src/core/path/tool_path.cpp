// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_paths/tool_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors/errors.h"

namespace tool_paths {
namespace {

using scan_cell_common::UnusableInput;

std::string name_of(const ToolPath& path, std::size_t segment, std::size_t waypoint) {
  return fmt::format("tool path '{}', segment {} waypoint {}", path.name, segment, waypoint);
}

void check(const Waypoint& waypoint, const ToolPath& path, const std::string& name) {
  constexpr double kOrthonormal = 1e-6;
  if (!waypoint.pose.matrix().allFinite()) {
    throw UnusableInput(name, "not finite", "correct the path");
  }
  const Eigen::Matrix3d rotation = waypoint.pose.linear();
  if (!(rotation * rotation.transpose()).isIdentity(kOrthonormal) || rotation.determinant() < 0) {
    throw UnusableInput(name, "its orientation is not a rotation", "give unit quaternions");
  }
  if (waypoint.process_values.size() != path.process_names.size()) {
    throw UnusableInput(name,
                        fmt::format("{} process values for {} names",
                                    waypoint.process_values.size(), path.process_names.size()),
                        "give each waypoint one value per name");
  }
  for (const double value : waypoint.process_values) {
    if (!std::isfinite(value)) {
      throw UnusableInput(name, "a process value is not finite", "correct the path");
    }
  }
}

}  // namespace

Points positions_of(const Segment& segment) {
  Points positions;
  for (const Waypoint& waypoint : segment.waypoints)
    positions.push_back(waypoint.pose.translation());
  return positions;
}

Points positions_of(const ToolPath& path) {
  Points positions;
  for (const Segment& segment : path.segments) {
    const Points more = positions_of(segment);
    positions.insert(positions.end(), more.begin(), more.end());
  }
  return positions;
}

std::size_t waypoint_count(const ToolPath& path) {
  std::size_t count = 0;
  for (const Segment& segment : path.segments)
    count += segment.waypoints.size();
  return count;
}

void check(const ToolPath& path) {
  if (waypoint_count(path) == 0) {
    throw UnusableInput("tool path '" + path.name + "'", "no waypoints",
                        "give at least one waypoint");
  }
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    const std::vector<Waypoint>& waypoints = path.segments[s].waypoints;
    if (waypoints.empty()) {
      throw UnusableInput(fmt::format("tool path '{}', segment {}", path.name, s), "no waypoints",
                          "remove the segment or fill it");
    }
    for (std::size_t w = 0; w < waypoints.size(); ++w)
      check(waypoints[w], path, name_of(path, s, w));
  }
}

namespace {

/// [m] along the segment to each waypoint
std::vector<double> arc_lengths(const Segment& segment) {
  std::vector<double> lengths = {0};
  for (std::size_t i = 1; i < segment.waypoints.size(); ++i) {
    const Eigen::Vector3d way =
        segment.waypoints[i].pose.translation() - segment.waypoints[i - 1].pose.translation();
    lengths.push_back(lengths.back() + way.norm());
  }
  return lengths;
}

Segment resampled(const Segment& segment, const std::vector<double>& lengths, std::size_t steps) {
  Segment result{segment.name, {segment.waypoints.front()}};
  std::size_t next = 1;
  for (std::size_t i = 1; i < steps; ++i) {
    const double at = lengths.back() * static_cast<double>(i) / static_cast<double>(steps);
    while (lengths[next] < at)
      ++next;
    const double share = (at - lengths[next - 1]) / (lengths[next] - lengths[next - 1]);
    result.waypoints.push_back(
        between(segment.waypoints[next - 1], segment.waypoints[next], share));
  }
  result.waypoints.push_back(segment.waypoints.back());
  return result;
}

}  // namespace

Waypoint between(const Waypoint& from, const Waypoint& to, double share) {
  Waypoint result = from;
  result.pose.translation() = (1 - share) * from.pose.translation() + share * to.pose.translation();
  const Eigen::Quaterniond start(from.pose.linear());
  result.pose.linear() =
      start.slerp(share, Eigen::Quaterniond(to.pose.linear())).normalized().toRotationMatrix();
  for (std::size_t i = 0; i < result.process_values.size(); ++i) {
    result.process_values[i] = (1 - share) * from.process_values[i] + share * to.process_values[i];
  }
  return result;
}

ToolPath resampled(const ToolPath& path, double spacing) {
  constexpr double kMost = 1e6;       // waypoints of a segment
  constexpr double kRounding = 1e-9;  // so that a segment of ten steps gets ten of them
  ToolPath result = path;
  for (Segment& segment : result.segments) {
    const std::vector<double> lengths = arc_lengths(segment);
    if (!(lengths.back() > 0)) continue;
    const double steps = std::ceil(lengths.back() / spacing - kRounding);
    if (!(steps <= kMost)) {
      throw UnusableInput("tool path '" + path.name + "'",
                          fmt::format("{:.6g} m long", lengths.back()),
                          "raise resample_spacing, or give the path in metres");
    }
    segment = resampled(segment, lengths, static_cast<std::size_t>(std::max(1.0, steps)));
  }
  return result;
}

std::vector<Eigen::Quaterniond> continuous_quaternions(const Segment& segment) {
  std::vector<Eigen::Quaterniond> result;
  for (const Waypoint& waypoint : segment.waypoints) {
    Eigen::Quaterniond rotation(waypoint.pose.linear());
    rotation.normalize();
    const double sign = result.empty() ? rotation.w() : rotation.dot(result.back());
    if (sign < 0) rotation.coeffs() *= -1;
    result.push_back(rotation);
  }
  return result;
}

}  // namespace tool_paths
