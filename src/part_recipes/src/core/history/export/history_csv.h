// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "history/history_rows.h"

namespace part_recipes {

/// The runs as a table, a line each: fields between commas as RFC 4180 has it, UTF-8, lengths in
/// mm and angles in degrees, empty what is not known; after them a column for each place that any
/// of the runs has.
std::string to_csv(const std::vector<HistoryRun>& runs);

}  // namespace part_recipes
