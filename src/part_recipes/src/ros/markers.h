// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/Marker.h>

#include <string>

#include "scan_cell_common/colours/colour_scale.h"
#include "tool_paths/tool_path.h"

namespace part_recipes {

std_msgs::ColorRGBA colour_of(const scan_cell_common::Rgb& rgb);

/// A marker with these points. Without points it removes the marker of that name.
/// @param type as visualization_msgs/Marker has it
/// @param size [m]
visualization_msgs::Marker marker_of(const std::string& name, int type,
                                     const tool_paths::Points& points, double size,
                                     const scan_cell_common::Rgb& colour,
                                     const std_msgs::Header& header);

}  // namespace part_recipes
