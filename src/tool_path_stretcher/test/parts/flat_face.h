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
  Loop points;                                        //!< [m] of the outline, then of each hole
  std::vector<std::vector<std::size_t>> rings;        //!< their numbers: outline to the left, holes
                                                      //!< to the right
  std::vector<std::array<std::size_t, 3>> triangles;  //!< to the left
};

/// The holes are joined to the outline by bridges, then ears are cut off.
/// @throw std::logic_error if a loop crosses itself or another one
FlatFace triangulated(const Loop& outline, const std::vector<Loop>& holes);

}  // namespace cases
