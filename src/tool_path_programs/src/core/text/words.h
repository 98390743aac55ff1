// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string_view>

namespace tool_path_programs {

using Words = std::set<std::string_view>;

/// Splits a list at blanks; the list must outlive the words.
Words words_of(std::string_view list);

}  // namespace tool_path_programs
