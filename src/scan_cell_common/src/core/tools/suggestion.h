// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace scan_cell_common {

/// The name somebody meant who typed `word`: the one with the fewest letters lost, added, changed
/// or swapped with their neighbour (optimal string alignment distance), or one that begins with it.
/// Dashes in front, underscores for dashes, and capitals do not count.
/// @return empty where none is near
std::string nearest_name(const std::string& word, const std::vector<std::string>& names);

}  // namespace scan_cell_common
