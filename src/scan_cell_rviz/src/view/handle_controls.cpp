// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/handle_controls.h"

#include <tf2_eigen/tf2_eigen.h>

namespace scan_cell_rviz {

using visualization_msgs::InteractiveMarkerControl;

/// A control moves along its x axis, or turns about it.
InteractiveMarkerControl control_of(const Eigen::Vector3d& axis, std::uint8_t mode,
                                    const std::string& name) {
  InteractiveMarkerControl control;
  control.orientation =
      tf2::toMsg(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), axis));
  control.interaction_mode = mode;
  control.name = name;
  return control;
}

void add_arrows_and_rings(visualization_msgs::InteractiveMarker& marker) {
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
    marker.controls.push_back(
        control_of(unit, InteractiveMarkerControl::MOVE_AXIS, "move_" + std::to_string(axis)));
    marker.controls.push_back(
        control_of(unit, InteractiveMarkerControl::ROTATE_AXIS, "turn_" + std::to_string(axis)));
  }
}

}  // namespace scan_cell_rviz
