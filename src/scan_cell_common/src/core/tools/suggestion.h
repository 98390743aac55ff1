// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace scan_cell_common {

/// The name probably meant by `word`: the one with the fewest letters lost, added, changed or
/// swapped with their neighbour (optimal string alignment distance), or one that begins with it.
/// Leading dashes, underscores for dashes, and capitals are ignored.
/// @return empty if none is near
std::string nearest_name(const std::string& word, const std::vector<std::string>& names);

}  // namespace scan_cell_common
