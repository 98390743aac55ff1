// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "run/run_record.h"

namespace part_recipes {

/// Takes state, reason, message and figures from the stretcher's report of a run.
/// @throw scan_cell_common::UnusableInput if it is no such report
void read_report(const std::filesystem::path& report, RunRecord& record);

/// Takes the deviations from deviation.json.
/// @throw scan_cell_common::UnusableInput if it is no such file
void read_deviations(const std::filesystem::path& summary, RunRecord& record);

/// Takes the hashes of the cell's calibration from what the cell said of a scan.
/// @throw scan_cell_common::UnusableInput if it cannot be read
void read_scan(const std::filesystem::path& scan, RunRecord& record);

/// Takes the times out of a report, which run.json has, so that the same run gives the same report.
/// @throw scan_cell_common::UnusableInput if it cannot be read
void take_times_out(const std::filesystem::path& report);

/// Puts into the report what it needs before the robot may work by it: when the scan was, how its
/// passes agree, the calibration.
/// @throw scan_cell_common::UnusableInput if one of them cannot be read
void complete_report(const std::filesystem::path& report, const std::filesystem::path& scan);

}  // namespace part_recipes
