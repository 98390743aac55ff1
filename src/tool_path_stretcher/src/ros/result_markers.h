// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/ColorRGBA.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include "tool_path_stretcher/stretcher.h"

namespace tool_path_stretcher {

/// Green at 0, yellow at 0.5 mm, red from 1 mm on; grey where the error [m] is not known.
std_msgs::ColorRGBA colour_of_error(double expected_error);

/// What a result is in rviz: `correspondences`, green lines between corresponding waypoints;
/// `waypoints`, the adapted ones in the colour of their expected error, normal and tangential
/// together; `refused`, red balls at the waypoints that the verdict is about, on the adapted path
/// or, where there is none, as the similarity lays the reference's. What there is none of is
/// deleted.
/// @param path as the goal gave it
/// @param header of the object's cloud
visualization_msgs::MarkerArray result_markers(const StretchResult& result, const ToolPath& path,
                                               const std_msgs::Header& header);

}  // namespace tool_path_stretcher
