// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool_path_stretcher/reported_verdict.h"
#include "tool_paths/path_edits.h"

namespace part_recipes {

/// A report of stretch about a path before a person edited it.
struct UneditedReport {
  std::string text;  //!< JSON
  std::string name;  //!< of its file, in errors
};

/// What the person did.
struct DoneEdits {
  std::vector<tool_paths::PathEdit> edits;
  std::string sha256;  //!< of their file
};

/// The report of the path after the edits: its file, its waypoints, how far off each may be (an
/// added waypoint: as far as the worse of its neighbours), and under `edits` what was done, in
/// words. If the path had been edited before, its earlier edits come first.
/// @param output the edited path's file
/// @throw scan_cell_common::UnusableInput if it is not a report, or has another number of waypoints
std::string edited_report(const UneditedReport& unedited, const tool_paths::EditedPath& edited,
                          const DoneEdits& done, const tool_path_stretcher::FileRecord& output);

}  // namespace part_recipes
