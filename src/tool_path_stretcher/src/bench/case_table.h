// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cases/case_list.h"

namespace bench {

/// Runs each case with the suite, the thesis' general method and PCL's own tools, and prints a
/// Markdown table with one line per case, and the totals.
/// @param yardsticks whether to run the two others as well
void print_case_table(const std::vector<cases::Case>& all, bool yardsticks);

}  // namespace bench
