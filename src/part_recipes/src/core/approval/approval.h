// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace part_recipes {

/// What a person said of a run.
struct Approval {
  bool approved = false;
  std::string name;  //!< of the person
  std::string note;
  std::string time;  //!< UTC, as utc_now() tells it
};

/// All that was said of a run, the last counts: from ID.approval.json beside its folder, which
/// stays as it was sealed.
/// @param run folder
/// @return empty where nobody said anything
/// @throw scan_cell_common::UnusableInput if the file is broken or from a newer version
std::vector<Approval> approvals_of(const std::filesystem::path& run);

/// Adds to what was said of a run, whole or not at all.
/// @throw scan_cell_common::FileError if there is no such run, or the file cannot be written
/// @throw scan_cell_common::InvalidParameter if the person has no name
/// @throw scan_cell_common::Refused if a run is approved whose path was not accepted
/// @throw as approvals_of()
void add_approval(const std::filesystem::path& run, const Approval& approval);

/// @throw scan_cell_common::Refused with name and note if the last person to say anything of the
/// run refused it
/// @throw as approvals_of()
void check_not_refused(const std::filesystem::path& run);

}  // namespace part_recipes
