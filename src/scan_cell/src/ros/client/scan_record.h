// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/CloudStatistics.h>
#include <scan_cell_msgs/ScanResult.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "scan_cell/ros/cell_client.h"

namespace scan_cell {

using Json = nlohmann::ordered_json;

/// Adds how the passes of a scan agree, as `passes`; nothing if there was only one sweep.
void add_passes(Json& all, const scan_cell_msgs::CloudStatistics& scan);

/// Name and SHA-256 of each file; the hash is null for a file that is not on this machine.
Json to_json(const CalibrationFiles& calibration);

/// Writes what the cell said about a scan: its time, how its frames were bound, how its passes
/// agree, the cell's calibration, and the camera's region.
/// @param region for passes that give none; none: not known, written as null
/// @throw scan_cell_common::FileError if it cannot be written
void save_scan_record(const std::string& file, const scan_cell_msgs::ScanResult& scan,
                      const CalibrationFiles& calibration,
                      const std::optional<CameraRegion>& region);

/// @throw scan_cell_common::FileError if it cannot be written
void save_json(const std::string& file, const Json& all);

}  // namespace scan_cell
