// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "record/run_record.h"

namespace part_recipes {

/// Takes reason, message and figures from the stretcher's report, and makes the report that of a
/// run: without times, which run.json has, so that the same run gives the same report; and with
/// what the robot needs before it may work by it: when the scan was, how its passes agree, the
/// calibration.
/// @param scan what the cell said of the scan; none: the cloud was given
/// @throw scan_cell_common::UnusableInput if one of them is no such file
void settle_report(const std::filesystem::path& report,
                   const std::optional<std::filesystem::path>& scan, RunRecord& record);

/// Takes the deviations from deviation.json.
/// @throw scan_cell_common::UnusableInput if it is no such file
void read_deviations(const std::filesystem::path& summary, RunRecord& record);

/// Takes the hashes of the cell's calibration from what the cell said of a scan.
/// @throw scan_cell_common::UnusableInput if it cannot be read
void read_scan(const std::filesystem::path& scan, RunRecord& record);

}  // namespace part_recipes
