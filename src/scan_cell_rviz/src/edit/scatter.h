// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace scan_cell_rviz {

/// Distributes points over pieces so that each piece is a thinned cloud. Of every `pieces`
/// consecutive points each piece gets one. Which one changes each time: otherwise, in a scan whose
/// lines have as many points, a piece would be stripes.
/// @param number index of the point in the piece, from 0
/// @return index of the point in the cloud; no two pieces share one
inline std::size_t scattered(std::size_t piece, std::size_t number, std::size_t pieces) {
  constexpr std::uint32_t kScatter = 2654435761;  // Knuth, The Art of Computer Programming 3, 6.4
  const std::uint32_t turn = (static_cast<std::uint32_t>(number) * kScatter) >> 16U;
  return number * pieces + (piece + turn) % pieces;
}

}  // namespace scan_cell_rviz
