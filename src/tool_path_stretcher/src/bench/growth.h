// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace bench {

/// Prints how time and memory grow from 20,000 to 1,000,000 points a cloud. Each size runs in a
/// process of its own, so that its peak of memory is its own: this program again, which then calls
/// run_growth().
void print_growth();

/// One size, in this process: prints what it came to.
/// @param reduced on the default grid; otherwise next to nothing is
void run_growth(std::size_t points, bool reduced);

}  // namespace bench
