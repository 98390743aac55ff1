// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "scan_cell_common/pose/units.h"
#include "scanner_views/figures/outcome.h"

namespace scanner_views {

/// How a case was answered.
struct CaseResult {
  std::string family;
  std::string name;
  bool to_accept = true;
  std::size_t points = 0;  //!< of the object's cloud
  Outcome ours;
  std::vector<Outcome> others;  //!< in the order of yardsticks(); empty: not run
};

/// Names of the yardsticks.
const std::vector<std::string>& yardsticks();

using scan_cell_common::kDegrees;

/// Text of a table cell; empty if unknown.
std::string cell_of(double value, int digits);
std::string percent_of(std::size_t part, std::size_t whole);

/// Prints Markdown tables: one line per case as it finishes, then one per family and one per
/// method.
void print_head(bool with_others);
void print_line(const CaseResult& result);
void print_sums(const std::vector<CaseResult>& results);

/// Saves all figures as JSON.
/// @throw scan_cell_common::FileError
void save_json(const std::string& file, std::uint64_t seed, const std::vector<CaseResult>& results);

}  // namespace scanner_views
