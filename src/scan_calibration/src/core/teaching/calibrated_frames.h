// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "scan_cell_common/scanner/scanner_model.h"
#include "teaching/cell_file.h"

namespace scan_calibration {

/// A frame that is fixed in its parent.
struct StaticFrame {
  std::string parent;
  std::string child;
  Eigen::Isometry3d pose;  //!< of child in parent [m]
};

/// Frame of a laser in camera_optical_frame: origin at the projector, z along the light towards the
/// point where its plane crosses the camera's optical axis, x the plane's normal. The line of light
/// therefore lies along y.
/// @throw scan_cell_common::UnusableInput if the plane does not cross the axis in front of the
/// camera
Eigen::Isometry3d laser_frame(const scan_cell_common::LaserPlane& laser, const std::string& name);

/// world -> base_link, tool0 -> camera_optical_frame -> laser_0, laser_1, and tool0 -> tool_tip.
/// @throw scan_cell_common::UnusableInput naming the laser that makes no sense
std::vector<StaticFrame> calibrated_frames(const scan_cell_common::ScannerModel& scanner,
                                           const Cell& cell);

}  // namespace scan_calibration
