// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace tool_path_programs {

/// With that many decimals, and a point in every locale; never "-0".
std::string fixed(double number, int digits);

/// As fixed(), without trailing zeros; a whole number has no point.
std::string shortest(double number, int digits);

/// With as many decimals as are needed to read back the same number.
std::string exact(double number);

/// Replaces a number in a text: at least as many decimals as it had, and at least `digits`.
std::string like(std::string_view old_text, double number, int digits);

}  // namespace tool_path_programs
