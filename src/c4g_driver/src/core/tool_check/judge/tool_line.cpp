// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_check/judge/tool_line.h"

#include "robot/path_check.h"
#include "scan_cell_common/pose/timed_pose.h"

namespace c4g_driver {

ToolLine::ToolLine(const ToolMotion& motion, std::size_t waypoint)
    : from_(&motion.waypoints[waypoint - 1].tip), to_(&motion.waypoints[waypoint].tip) {
  const Eigen::Matrix<double, 6, 1> change = twist(*from_, *to_);
  move_ = change.head<3>();
  turn_ = change.tail<3>();
}

Eigen::Isometry3d ToolLine::tip(double way) const {
  return scan_cell_common::interpolate(*from_, *to_, way);
}

int ToolLine::steps() const {
  return static_cast<int>(steps_along({0, 1, length(), angle(), ""}));
}

Eigen::Matrix<double, 6, 1> ToolLine::flange_rate(const Eigen::Isometry3d& tip,
                                                  const Eigen::Isometry3d& flange) const {
  Eigen::Matrix<double, 6, 1> rate;
  rate << move_ + turn_.cross(flange.translation() - tip.translation()), turn_;
  return rate;
}

}  // namespace c4g_driver
