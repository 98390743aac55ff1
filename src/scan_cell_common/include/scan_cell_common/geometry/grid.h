// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace scan_cell_common {

/// A grid through the origin that sorts points into cells.
struct Grid {
  Eigen::Vector3d leaf;     //!< [m] edges of a cell, above 0
  std::array<int, 3> axes;  //!< order of cells, the most significant axis first
  double max_cells;         //!< from the origin along an axis; at most 1e15, to stay exact

  /// Number of the cell along an axis.
  /// @param point index of the point, for the error
  /// @throw UnusableInput if the coordinate is not finite or is beyond `max_cells`
  std::int64_t cell(double coordinate, int axis, std::size_t point) const;
};

/// A point in a cell of a grid.
struct GridEntry {
  std::array<std::int64_t, 3> cell;  //!< along each axis, in the order of Grid::axes
  std::uint32_t point;               //!< its index

  /// By cell, then by point.
  bool operator<(const GridEntry& other) const {
    return cell != other.cell ? cell < other.cell : point < other.point;
  }
};

/// All points, sorted by cell, and within a cell by index. Cells are counted in 64 bits and sorted,
/// so that neither the extent of the cloud nor the order of a hash table can affect the result.
/// @param position of a point by its index [m]
/// @throw UnusableInput as Grid::cell()
template <class Position>
std::vector<GridEntry> sort_into_grid(std::size_t points, const Position& position,
                                      const Grid& grid) {
  std::vector<GridEntry> entries(points);
  for (std::size_t i = 0; i < points; ++i) {
    const Eigen::Vector3d at = position(i);
    for (std::size_t k = 0; k < 3; ++k)
      entries[i].cell[k] = grid.cell(at[grid.axes[k]], grid.axes[k], i);
    entries[i].point = static_cast<std::uint32_t>(i);
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Calls visit(begin, end) with the entries of each cell.
template <class Visit>
void for_each_cell(const std::vector<GridEntry>& entries, const Visit& visit) {
  for (auto begin = entries.begin(); begin != entries.end();) {
    auto end = begin;
    while (end != entries.end() && end->cell == begin->cell)
      ++end;
    visit(begin, end);
    begin = end;
  }
}

}  // namespace scan_cell_common
