// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "teaching/calibrated_frames.h"

#include <cmath>

#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

void refuse(const std::string& name, const std::string& value) {
  throw scan_cell_common::UnusableInput("scanner model: " + name, value,
                                        "calibrate the laser again");
}

}  // namespace

Eigen::Isometry3d laser_frame(const scan_cell_common::LaserPlane& laser, const std::string& name) {
  constexpr double kMinDistance = 1e-3;                    // [m] chosen
  const double depth = laser.distance / laser.normal.z();  // of the crossing: n.z depth = distance
  if (!(std::isfinite(depth) && depth > kMinDistance)) {
    refuse(name, "its plane does not cross the optical axis in front of the camera");
  }
  const Eigen::Vector3d light = Eigen::Vector3d(0, 0, depth) - laser.origin;
  if (light.norm() < kMinDistance) refuse(name, "its origin lies where its plane crosses the axis");
  // The origin may be off its plane by the calibration's error: project the light onto it
  const Eigen::Vector3d z = (light - light.dot(laser.normal) * laser.normal).normalized();
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear().col(0) = laser.normal.normalized();
  frame.linear().col(1) = z.cross(laser.normal.normalized());
  frame.linear().col(2) = z;
  frame.translation() = laser.origin;
  return frame;
}

std::vector<StaticFrame> calibrated_frames(const scan_cell_common::ScannerModel& scanner,
                                           const Cell& cell) {
  std::vector<StaticFrame> frames = {{"world", "base_link", cell.base_link_in_world},
                                     {"tool0", "tool_tip", cell.tool_tip_in_tool0},
                                     {"tool0", "camera_optical_frame", scanner.flange_to_camera}};
  for (std::size_t i = 0; i < scanner.lasers.size(); ++i) {
    if (!scanner.has_laser(i)) continue;
    const std::string name = scan_cell_common::laser_name(i);
    frames.push_back({"camera_optical_frame", name, laser_frame(scanner.laser(i), name)});
  }
  return frames;
}

}  // namespace scan_calibration
