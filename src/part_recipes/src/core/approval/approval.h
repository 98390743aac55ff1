// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace part_recipes {

/// What a person said about a run.
struct Approval {
  bool approved = false;
  std::string name;  //!< of the person
  std::string note;
  std::string time;  //!< UTC, as from utc_now()
};

/// Everything that was said about a run, from ID.approval.json beside its folder (the folder stays
/// as it was sealed). The last entry counts.
/// @param run folder
/// @return empty if nobody said anything
/// @throw scan_cell_common::UnusableInput if the file is broken or from a newer version
std::vector<Approval> approvals_of(const std::filesystem::path& run);

/// Adds an approval or a refusal of a run, whole or not at all.
/// @throw scan_cell_common::FileError if there is no such run, or the file cannot be written
/// @throw scan_cell_common::InvalidParameter if the person has no name
/// @throw scan_cell_common::Refused if a run is approved whose path was not accepted
/// @throw as approvals_of()
void add_approval(const std::filesystem::path& run, const Approval& approval);

/// @throw scan_cell_common::Refused, with name and note, if the last person to say anything about
/// the run refused it
/// @throw as approvals_of()
void check_not_refused(const std::filesystem::path& run);

}  // namespace part_recipes
