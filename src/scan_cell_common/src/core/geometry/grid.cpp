// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/geometry/grid.h"

#include <fmt/format.h>

#include <cmath>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {

std::int64_t Grid::cell(double coordinate, int axis, std::size_t point) const {
  const double cell = std::floor(coordinate / leaf[axis]);
  if (std::abs(cell) < max_cells) return static_cast<std::int64_t>(cell);  // false for NaN
  throw UnusableInput(fmt::format("point {}", point),
                      fmt::format("at {:.6g} m, too many cells from the origin", coordinate),
                      "remove outliers and points that are not finite, set limits, or take larger "
                      "cells");
}

}  // namespace scan_cell_common
