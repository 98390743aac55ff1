// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace bench {

/// Prints how time and memory grow from 20,000 to 1,000,000 points per cloud. Each size runs in a
/// separate process of this program, which calls run_growth(), so that its peak memory is its own.
void print_growth();

/// Runs one size in this process and prints the result.
/// @param reduced on the default grid; otherwise hardly at all
void run_growth(std::size_t points, bool reduced);

}  // namespace bench
