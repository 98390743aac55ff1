// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "history/history_rows.h"

namespace part_recipes {

/// The runs as a table, one line each: fields separated by commas as in RFC 4180, UTF-8, lengths in
/// mm and angles in degrees, empty where not known. The last columns are the places that any of the
/// runs has.
std::string to_csv(const std::vector<HistoryRun>& runs);

}  // namespace part_recipes
