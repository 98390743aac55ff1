// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "result_markers.h"

#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>
#include <cmath>

namespace tool_path_stretcher {
namespace {

using visualization_msgs::Marker;

std_msgs::ColorRGBA colour(double r, double g, double b, double a = 1) {
  std_msgs::ColorRGBA result;
  result.r = static_cast<float>(r);
  result.g = static_cast<float>(g);
  result.b = static_cast<float>(b);
  result.a = static_cast<float>(a);
  return result;
}

Marker marker(const std_msgs::Header& header, const std::string& name, int type, double size) {
  Marker result;
  result.header = header;
  result.ns = name;
  result.type = type;
  result.pose.orientation.w = 1;
  result.scale.x = result.scale.y = result.scale.z = size;
  return result;
}

/// Marks the marker to be added, or deleted if it is empty.
Marker finished(Marker marker) {
  marker.action = marker.points.empty() ? Marker::DELETE : Marker::ADD;
  return marker;
}

Marker correspondences(const Points& from, const Points& to, const std_msgs::Header& header) {
  constexpr double kWidth = 0.0005;  // [m] chosen
  Marker lines = marker(header, "correspondences", Marker::LINE_LIST, kWidth);
  lines.color = colour(0, 1, 0, 0.6);
  for (std::size_t i = 0; i < to.size(); ++i) {
    lines.points.push_back(tf2::toMsg(from[i]));
    lines.points.push_back(tf2::toMsg(to[i]));
  }
  return finished(lines);
}

Marker waypoints(const StretchResult& result, const Points& at, const std_msgs::Header& header) {
  constexpr double kSize = 0.002;  // [m] chosen
  Marker balls = marker(header, "waypoints", Marker::SPHERE_LIST, kSize);
  balls.color.a = 1;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const WaypointQuality& quality = result.quality[i];
    balls.points.push_back(tf2::toMsg(at[i]));
    balls.colors.push_back(quality.in_air
                               ? colour(0.3, 0.6, 1)
                               : colour_of_error(std::hypot(quality.expected_error_normal,
                                                            quality.expected_error_tangential)));
  }
  return finished(balls);
}

Marker refused(const Verdict& verdict, const Points& at, const std_msgs::Header& header) {
  constexpr double kSize = 0.005;  // [m] chosen: larger than a waypoint
  Marker balls = marker(header, "refused", Marker::SPHERE_LIST, kSize);
  balls.color = colour(0.9, 0.1, 0.1);
  for (const std::size_t waypoint : verdict.waypoints) {
    if (waypoint < at.size()) balls.points.push_back(tf2::toMsg(at[waypoint]));
  }
  return finished(balls);
}

}  // namespace

std_msgs::ColorRGBA colour_of_error(double expected_error) {
  constexpr double kRed = 0.001;  // [m] chosen
  if (std::isnan(expected_error)) return colour(0.5, 0.5, 0.5);
  const double share = std::min(expected_error / kRed, 1.0);
  return colour(std::min(2 * share, 1.0), std::min(2 - 2 * share, 1.0), 0);
}

visualization_msgs::MarkerArray result_markers(const StretchResult& result, const ToolPath& path,
                                               const std_msgs::Header& header) {
  const Points adapted = positions_of(result.path);
  Points laid = adapted;
  if (adapted.empty()) {
    laid = positions_of(result.reference_path.segments.empty() ? path : result.reference_path);
    for (Eigen::Vector3d& point : laid)
      point = result.similarity * point;
  }
  visualization_msgs::MarkerArray markers;
  markers.markers = {correspondences(positions_of(result.reference_path), adapted, header),
                     waypoints(result, adapted, header), refused(result.verdict, laid, header)};
  return markers;
}

}  // namespace tool_path_stretcher
