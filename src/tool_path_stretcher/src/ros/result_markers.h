// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/ColorRGBA.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "tool_path_stretcher/stretcher.h"

namespace tool_path_stretcher {

/// Green at 0, yellow at 0.5 mm, red from 1 mm; grey if the error [m] is unknown.
std_msgs::ColorRGBA colour_of_error(double expected_error);

/// A result as markers for rviz. `correspondences`: green lines between corresponding waypoints.
/// `waypoints`: the adapted ones, coloured by expected error, normal and tangential combined.
/// `refused`: red balls at the waypoints that the verdict is about, on the adapted path or, if
/// there is none, on the reference's as the similarity lays it. Empty markers are deleted.
/// @param path the goal's path
/// @param header of the object's cloud
visualization_msgs::MarkerArray result_markers(const StretchResult& result, const ToolPath& path,
                                               const std_msgs::Header& header);

}  // namespace tool_path_stretcher
