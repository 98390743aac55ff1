// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/grid_cells.h"

#include "scan_cell_common/geometry/cell_means.h"

namespace cloud_preprocess {
namespace {

using scan_cell_common::CellMeans;
using scan_cell_common::CellSum;
using scan_cell_common::Grid;

/// @param means_of cells, in a grid
template <class MeansOf>
GridCells sort(const scan_cell_common::Cloud& cloud, const Eigen::Vector3d& leaf,
               const MeansOf& means_of) {
  constexpr double kMaxCells = 1 << 20;  // chosen: a part of 2 m has 4000 cells of 0.5 mm
  const Grid grid{leaf, {2, 1, 0}, kMaxCells};
  const auto position = [&cloud](std::size_t i) -> Eigen::Vector3d {
    return cloud[i].getVector3fMap().cast<double>();
  };
  const auto entries = scan_cell_common::sort_into_grid(cloud.size(), position, grid);
  const CellMeans means = means_of(scan_cell_common::sums_of_cells(entries, position), grid);
  GridCells cells;
  for (const Eigen::Vector3d& mean : means.means) {
    const Eigen::Vector3f at = mean.cast<float>();
    cells.means.push_back({at.x(), at.y(), at.z()});
  }
  cells.cell_of_point.resize(cloud.size());
  std::size_t cell = 0;
  for_each_cell(entries, [&](auto begin, auto end) {
    for (auto each = begin; each != end; ++each)
      cells.cell_of_point[each->point] = means.mean_of_cell[cell];
    ++cell;
  });
  return cells;
}

CellMeans as_they_are(const std::vector<CellSum>& cells, const Grid&) {
  CellMeans means;
  for (const CellSum& cell : cells) {
    means.mean_of_cell.push_back(static_cast<std::uint32_t>(means.means.size()));
    means.means.push_back(cell.sum / cell.count);
  }
  return means;
}

}  // namespace

GridCells sort_into_grid(const scan_cell_common::Cloud& cloud, const Eigen::Vector3d& leaf) {
  return sort(cloud, leaf, as_they_are);
}

GridCells sort_into_pieces(const scan_cell_common::Cloud& cloud, const Eigen::Vector3d& leaf) {
  return sort(cloud, leaf, scan_cell_common::joined_means);
}

}  // namespace cloud_preprocess
