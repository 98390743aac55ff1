// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace tool_path_programs {

/// With that many digits behind the point, which is a point in every locale; never "-0".
std::string fixed(double number, int digits);

/// As fixed(), without zeros at the end; a whole number has no point.
std::string shortest(double number, int digits);

/// With as many digits behind the point as it takes to come back the same.
std::string exact(double number);

/// What stands in place of a number when only its value changes: with at least as many digits
/// behind the point as it had, and at least `digits`.
std::string like(std::string_view old_text, double number, int digits);

}  // namespace tool_path_programs
