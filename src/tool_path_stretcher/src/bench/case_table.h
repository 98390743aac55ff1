// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cases/case_list.h"

namespace bench {

/// Runs each case by the suite, by the thesis' general method and by PCL's own tools, and prints a
/// table in Markdown, a line a case, and what they came to.
/// @param yardsticks whether the two others run as well
void print_case_table(const std::vector<cases::Case>& all, bool yardsticks);

}  // namespace bench
