// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace part_recipes {

/// Which runs to select: those that meet all given conditions.
struct HistoryFilter {
  std::optional<std::string> id;
  std::optional<std::string> recipe;  //!< its whole name
  std::optional<std::string> state;   //!< accepted, refused or unusable
  std::optional<std::string> reason;  //!< the whole word
  std::optional<std::string>
      since;  //!< start, UTC: 2026, 2026-11, 2026-11-25, 2026-11-25T12:13 ...
  std::optional<std::string> until;    //!< the same, and all that begins with it
  std::optional<std::string> text;     //!< somewhere in id, recipe, reason, message, host or note
  std::optional<std::uint64_t> limit;  //!< only the last ones, at most this many
};

/// Whether a text is a time as in run.json, or the beginning of one down to the year.
bool is_time(const std::string& text);

/// Whether the time is whole, down to the second.
bool is_whole_time(const std::string& text);

/// The filter with its times in the form in which the database compares them.
/// @throw scan_cell_common::InvalidParameter naming what is wrong
HistoryFilter checked(HistoryFilter filter);

}  // namespace part_recipes
