// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scanner_views/view_case.h"

namespace scanner_views {

/// All cases of a seed, with random dimensions, poses, deformations, views and paths. Includes real
/// parts if `data` has them.
/// @param data folder with parts/; empty: none
std::vector<ViewCase> all_cases(std::uint64_t seed, const std::string& data);

}  // namespace scanner_views
