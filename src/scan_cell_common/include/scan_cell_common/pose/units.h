// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace scan_cell_common {

constexpr double kMillimetre = 1e-3;     //!< [m]
constexpr double kMillimetres = 1e3;     //!< in a metre
constexpr double kDegree = M_PI / 180;   //!< [rad]
constexpr double kDegrees = 180 / M_PI;  //!< in a radian

/// The units of length that a file may use: m, mm, inch. The suite itself uses metres.
const std::vector<std::string>& length_units();

/// Metres in one of them: 1, 0.001, 0.0254.
/// @throw InvalidParameter if it is not one of length_units()
double metres_per(const std::string& unit);

}  // namespace scan_cell_common
