// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace scan_cell_common {

/// Red, green and blue, 0 .. 1.
using Rgb = std::array<float, 3>;

/// Dark blue to yellow, brighter with every step, so that it can be read without colour; five
/// colours of matplotlib's viridis.
/// @param share of the way to the bright end; values beyond an end have its colour, NaN is grey
Rgb brightening(double share);

/// Blue over white to brown, whose ends can be told apart with any usual colour blindness. In greys
/// both ends look alike, so signs need marks as well.
/// @param share -1 .. 1; values beyond an end have its colour, NaN is purple
Rgb diverging(double share);

}  // namespace scan_cell_common
