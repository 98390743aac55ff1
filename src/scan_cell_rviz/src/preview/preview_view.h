// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/WorkPreview.h>

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "scan_cell_common/colours/colour_scale.h"

/// What a preview of the work shows at one of its poses.
namespace scan_cell_rviz {

/// Whether the preview is of the path of that run.
bool is_of_run(const scan_cell_msgs::WorkPreview& preview, const QString& run);

/// [rad] by name; empty: the robot does not reach the pose, or there is none.
std::map<std::string, double> joints_at(const scan_cell_msgs::WorkPreview& preview,
                                        std::size_t pose);

/// Such as "waypoint 12: 50 mm/s, output 3 on", and under it "J1 12.3, J2 -45.6 degrees".
QString text_at(const scan_cell_msgs::WorkPreview& preview, std::size_t pose);

/// Whether the way to a pose is along the path itself, not to the path or away from it.
bool is_along_path(const scan_cell_msgs::WorkPreview& preview, std::size_t pose);

/// [m/s] on the way along the path itself.
struct SpeedRange {
  double least = 0;
  double most = 0;
};

SpeedRange speeds_of(const scan_cell_msgs::WorkPreview& preview);

/// Colour of a speed: from dark blue (lowest) to yellow (highest).
scan_cell_common::Rgb colour_of(double speed, const SpeedRange& range);

}  // namespace scan_cell_rviz
