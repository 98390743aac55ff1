// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/InteractiveMarker.h>

#include <Eigen/Geometry>
#include <string>

namespace scan_cell_rviz {

/// A control along or about an axis of its marker.
/// @param axis of length 1 @param mode of the control, such as MOVE_AXIS
visualization_msgs::InteractiveMarkerControl control_of(const Eigen::Vector3d& axis,
                                                        std::uint8_t mode, const std::string& name);

/// An arrow along, and a ring about, each axis of the marker.
void add_arrows_and_rings(visualization_msgs::InteractiveMarker& marker);

}  // namespace scan_cell_rviz
