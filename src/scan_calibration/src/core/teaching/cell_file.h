// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

namespace scan_calibration {

/// Poses of the cell (cell.yaml; docs/scan_calibration.md).
struct Cell {
  Eigen::Isometry3d base_link_in_world = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d tool_tip_in_tool0 = Eigen::Isometry3d::Identity();
};

/// @throw scan_cell_common::FileError if the file is missing or not YAML
/// @throw scan_cell_common::UnusableInput naming the entry that is missing, unknown or invalid
Cell load_cell(const std::string& path);

/// Writes both entries, completely or not at all.
/// @throw scan_cell_common::FileError if it cannot be written
void save_cell(const std::string& path, const Cell& cell);

/// Loads one entry of a file that may lack the other, as the tool is calibrated before the world.
/// @throw as load_cell()
Eigen::Isometry3d load_cell_entry(const std::string& path, const std::string& entry);

/// Writes one entry and keeps the other; creates the file if it is missing.
/// @param entry "base_link_in_world" or "tool_tip_in_tool0"
/// @throw as load_cell() and save_cell()
void update_cell_entry(const std::string& path, const std::string& entry,
                       const Eigen::Isometry3d& pose);

}  // namespace scan_calibration
