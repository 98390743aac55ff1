// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace part_recipes {

/// Those of NAME, NAME_2, NAME_3 ... that have a .json or a .log, up to the first that has none.
std::vector<std::string> taken_names(const std::string& wanted);

/// The first of NAME, NAME_2, NAME_3 ... that no .json and no .log has: no record takes the place
/// of another.
std::string free_name(const std::string& wanted);

}  // namespace part_recipes
