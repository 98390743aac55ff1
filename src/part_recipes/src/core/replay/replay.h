// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "record/run_record.h"
#include "replay/job_folder.h"
#include "run/calls/tool_call.h"

namespace part_recipes {

/// Called with the id of a job when it begins.
using JobBegins = std::function<void(const std::string& id)>;

/// Does the jobs of a folder until each is done or somebody else is working on it. A stopped job is
/// given back.
/// @param lease of the claims; the worker touches its claim four times in it
/// @return number of jobs it did
/// @throw scan_cell_common::Error if a recorded run is unusable; its claim is given back
std::size_t work_on(const JobFolder& folder, std::chrono::seconds lease, const JobBegins& begins,
                    const Stop& stop);

/// One recorded run beside the result with the other recipe.
struct ReplayedRun {
  std::string id;
  RunRecord before, after;
  std::optional<double> moved_rms,
      moved_most;  //!< [m] of the waypoints; both accepted, and as many
};

/// All finished jobs, by id.
/// @throw scan_cell_common::Error if a run cannot be read
std::vector<ReplayedRun> replayed(const JobFolder& folder);

/// In words: the verdicts that changed, and the waypoints that moved.
std::string to_text(const std::vector<ReplayedRun>& runs);

}  // namespace part_recipes
