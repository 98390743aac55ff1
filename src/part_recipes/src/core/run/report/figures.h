// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

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

/// Adds to the message of a refusal, in the report and in the record, that the scan had points
/// where the clean cloud has none, and to the report the numbers of these waypoints
/// (`cleaned_away`). Nothing is added where there are none.
/// @param taken waypoints at which the clean cloud lacks the points of the scan
/// @throw scan_cell_common::UnusableInput if the report is none
void tell_cleaned_away(const std::filesystem::path& report, const std::vector<std::size_t>& taken,
                       RunRecord& record);

/// Takes reason, message and figures from a report that was settled.
/// @throw scan_cell_common::UnusableInput if it is none
void read_figures(const std::filesystem::path& report, RunRecord& record);

/// Takes the deviations from deviation.json.
/// @throw scan_cell_common::UnusableInput if it is no such file
void read_deviations(const std::filesystem::path& summary, RunRecord& record);

/// Takes the hashes of the cell's calibration from what the cell said of a scan.
/// @throw scan_cell_common::UnusableInput if it cannot be read
void read_scan(const std::filesystem::path& scan, RunRecord& record);

/// What a scan was made with, as far as the cell told.
struct ScannedWith {
  std::string scanner;              //!< file of the scanner model; empty: not known
  std::string sha256;               //!< of that; empty: it was on another machine
  std::vector<std::string> region;  //!< of the camera, as options of seen_waypoints
};

/// @throw scan_cell_common::UnusableInput if it cannot be read
ScannedWith read_scanned_with(const std::filesystem::path& scan);

}  // namespace part_recipes
