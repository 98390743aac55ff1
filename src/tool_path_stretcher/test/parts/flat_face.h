// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "parts/solids.h"

namespace cases {

/// A flat face with holes as triangles.
struct FlatFace {
  Loop points;  //!< [m] points of the outline, then of each hole
  std::vector<std::vector<std::size_t>>
      rings;  //!< indices: outline counter-clockwise, holes clockwise
  std::vector<std::array<std::size_t, 3>> triangles;  //!< counter-clockwise
};

/// Triangulates: joins the holes to the outline by bridges, then cuts off ears.
/// @throw std::logic_error if a loop crosses itself or another one
FlatFace triangulated(const Loop& outline, const std::vector<Loop>& holes);

}  // namespace cases
