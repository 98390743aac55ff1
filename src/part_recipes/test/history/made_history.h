// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "record/run_record.h"

namespace part_recipes {

/// Runs as a cell might have made them, five minutes apart, with deviations of 0.05 mm (standard
/// deviation) at the places "left flank", "right flank" and "rim". The left flank drifts by 0.3 mm
/// over the last quarter. One run in twelve was refused, half of these with figures. After two
/// thirds the clock was set back by an hour; after a third the recipe was changed.
std::vector<RunRecord> made_history(std::size_t count, const std::string& recipe);

}  // namespace part_recipes
