// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "scan_cell_common/geometry/grid.h"

namespace scan_cell_common {

/// The points of one cell, together.
struct CellSum {
  std::array<std::int64_t, 3> cell;                   //!< as GridEntry has it
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();      //!< [m] of its points
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();  //!< [m^2] of its points, summed
  double count = 0;                                   //!< of its points
};

/// Those of all cells, in their order.
/// @param entries as sort_into_grid() gives them
/// @param position of a point by its index [m]
template <class Position>
std::vector<CellSum> sums_of_cells(const std::vector<GridEntry>& entries,
                                   const Position& position) {
  std::vector<CellSum> sums;
  for_each_cell(entries, [&](auto begin, auto end) {
    CellSum& sum = sums.emplace_back(CellSum{begin->cell});
    for (auto each = begin; each != end; ++each) {
      const Eigen::Vector3d at = position(each->point);
      sum.sum += at;
      sum.squares += at.cwiseAbs2();
    }
    sum.count = static_cast<double>(end - begin);
  });
  return sums;
}

/// One point for each piece of a surface.
struct CellMeans {
  std::vector<Eigen::Vector3d> means;       //!< [m] in the order of the cells
  std::vector<std::uint32_t> mean_of_cell;  //!< one a cell: the index of its mean
};

/// The means of cells, where two neighbours are one piece of a surface if their means are less than
/// half a cell apart across their border and hardly along it, or one has few points beside the
/// other and is less than a cell apart; and only across a border along which the fuller one does
/// not fill its cell. A surface near a border has points on both sides, by its noise: taken as two,
/// the few beyond the border would count for as much as all others, and shift it by up to its
/// noise.
CellMeans joined_means(const std::vector<CellSum>& cells, const Grid& grid);

}  // namespace scan_cell_common
