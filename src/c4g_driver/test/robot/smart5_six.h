// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "c4g_driver/robot_model.h"
#include "scan_cell_common/files/files.h"

/// The robot of the package's URDF.
inline const c4g_driver::RobotModel& smart5_six() {
  static const c4g_driver::RobotModel robot(scan_cell_common::read_file(URDF_FILE), "base_link",
                                            "flange");
  return robot;
}

inline Eigen::Isometry3d looking_down(double x, double y, double z) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << x, y, z;
  pose.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  return pose;
}

inline c4g_driver::Joints degrees(double j1, double j2, double j3, double j4, double j5,
                                  double j6) {
  return (c4g_driver::Joints() << j1, j2, j3, j4, j5, j6).finished() * M_PI / 180;
}
