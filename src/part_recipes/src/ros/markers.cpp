// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "markers.h"

#include <tf2_eigen/tf2_eigen.h>

namespace part_recipes {

using visualization_msgs::Marker;

std_msgs::ColorRGBA colour_of(const scan_cell_common::Rgb& rgb) {
  std_msgs::ColorRGBA colour;
  colour.r = rgb[0];
  colour.g = rgb[1];
  colour.b = rgb[2];
  colour.a = 1;
  return colour;
}

Marker marker_of(const std::string& name, int type, const tool_paths::Points& points, double size,
                 const scan_cell_common::Rgb& colour, const std_msgs::Header& header) {
  Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.type = type;
  marker.action = points.empty() ? Marker::DELETE : Marker::ADD;
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = size;
  marker.color = colour_of(colour);
  for (const Eigen::Vector3d& point : points)
    marker.points.push_back(tf2::toMsg(point));
  return marker;
}

}  // namespace part_recipes
