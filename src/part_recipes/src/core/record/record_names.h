// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace part_recipes {

/// Names among NAME, NAME_2, NAME_3 ... that have a .json or a .log, up to the first that has
/// neither.
std::vector<std::string> taken_names(const std::string& wanted);

/// The first of NAME, NAME_2, NAME_3 ... that has neither a .json nor a .log, so that no record
/// replaces another.
std::string free_name(const std::string& wanted);

}  // namespace part_recipes
