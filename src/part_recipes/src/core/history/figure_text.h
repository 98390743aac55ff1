// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "record/run_record.h"

namespace part_recipes {

/// The known figures of a run, by name, each with its unit: mm, deg, or none for a ratio. Places of
/// the part come last, as "place NAME"; a place without a known deviation says so.
std::vector<std::pair<std::string, std::string>> texts_of(const RunFigures& figures);

/// A length in mm with four decimals, "-" if it is not known.
std::string millimetres_of(const std::optional<double>& metres);

}  // namespace part_recipes
