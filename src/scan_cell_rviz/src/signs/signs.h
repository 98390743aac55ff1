// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <scan_cell_msgs/CellState.h>
#include <scan_cell_msgs/RobotStatus.h>
#include <scan_cell_msgs/TriggerState.h>

#include <QString>

#include "signs/sign.h"

namespace scan_cell_rviz {

/// The worst state first: connection, emergency stop, alarms, drives, mode.
Sign sign_of(const scan_cell_msgs::RobotStatus& robot);

/// Of the laser lines; a laser that is on comes first.
Sign sign_of(const scan_cell_msgs::TriggerState& trigger);

Sign sign_of(const scan_cell_msgs::CellState& cell);

/// Of the camera.
Sign sign_of(const diagnostic_msgs::DiagnosticStatus& camera);

/// An age in whole days.
/// @param age [s]
QString age_text(double age);

/// Of the scanner model: its name, the first digits of its hash, and its age.
/// @param sha256 empty: the file cannot be read on this computer
/// @param age [s] since it was written
Sign calibration_sign(const std::string& file, const std::string& sha256, double age);

}  // namespace scan_cell_rviz
