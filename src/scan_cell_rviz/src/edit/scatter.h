// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace scan_cell_rviz {

/// Points dealt out to pieces so that each piece is the cloud thinned. Of each run of as many
/// points as there are pieces each piece has one; which one changes from run to run, or a piece
/// would be stripes of a scan whose lines are as long.
/// @param number counts the points of the piece, from 0
/// @return number of the point in the cloud; no two pieces have the same
inline std::size_t scattered(std::size_t piece, std::size_t number, std::size_t pieces) {
  constexpr std::uint32_t kScatter = 2654435761;  // Knuth, The Art of Computer Programming 3, 6.4
  const std::uint32_t turn = (static_cast<std::uint32_t>(number) * kScatter) >> 16U;
  return number * pieces + (piece + turn) % pieces;
}

}  // namespace scan_cell_rviz
