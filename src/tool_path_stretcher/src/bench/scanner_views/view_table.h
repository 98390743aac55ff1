// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scanner_views/outcome.h"

namespace scanner_views {

/// How a case was answered.
struct CaseResult {
  std::string family;
  std::string name;
  bool to_accept = true;
  std::size_t points = 0;  //!< of the object's cloud
  Outcome ours;
  std::vector<Outcome> others;  //!< in the order of the yardsticks' names; empty: not run
};

/// Names of the yardsticks.
const std::vector<std::string>& yardsticks();

/// Tables in Markdown: a line a case as it comes, then a line a family.
void print_head(bool with_others);
void print_line(const CaseResult& result);
void print_sums(const std::vector<CaseResult>& results, bool with_others);

/// All figures as JSON.
/// @throw scan_cell_common::FileError
void save_json(const std::string& file, std::uint64_t seed, const std::vector<CaseResult>& results);

}  // namespace scanner_views
