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

/// Takes reason, message and figures from the stretcher's report, and turns the report into that of
/// a run. Times are removed (run.json has them), so that the same run gives the same report. What
/// the robot needs before it may work by it is added: when the scan was made, how its passes agree,
/// the calibration.
/// @param scan the cell's record of the scan; none: the cloud was given
/// @throw scan_cell_common::UnusableInput if one of the files is not of its kind
void settle_report(const std::filesystem::path& report,
                   const std::optional<std::filesystem::path>& scan, RunRecord& record);

/// If the scan had points where the clean cloud has none, adds this to the message of a refusal, in
/// the report and in the record, and adds the numbers of these waypoints to the report
/// (`cleaned_away`). Without such waypoints nothing is added.
/// @param taken waypoints at which the clean cloud lacks the points of the scan
/// @throw scan_cell_common::UnusableInput if the report is invalid
void tell_cleaned_away(const std::filesystem::path& report, const std::vector<std::size_t>& taken,
                       RunRecord& record);

/// Takes reason, message and figures from a settled report.
/// @throw scan_cell_common::UnusableInput if it is invalid
void read_figures(const std::filesystem::path& report, RunRecord& record);

/// Takes the deviations from deviation.json.
/// @throw scan_cell_common::UnusableInput if the file is not of that kind
void read_deviations(const std::filesystem::path& summary, RunRecord& record);

/// Takes the hashes of the cell's calibration from the cell's record of a scan.
/// @throw scan_cell_common::UnusableInput if it cannot be read
void read_scan(const std::filesystem::path& scan, RunRecord& record);

/// What a scan was made with, as told by the cell.
struct ScannedWith {
  std::string scanner;              //!< file of the scanner model; empty: not known
  std::string sha256;               //!< of that; empty: it was on another machine
  std::vector<std::string> region;  //!< of the camera, as options of seen_waypoints
};

/// @throw scan_cell_common::UnusableInput if it cannot be read
ScannedWith read_scanned_with(const std::filesystem::path& scan);

}  // namespace part_recipes
