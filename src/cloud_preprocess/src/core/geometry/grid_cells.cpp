// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/grid_cells.h"

#include "scan_cell_common/geometry/even_cells.h"

namespace cloud_preprocess {
namespace {

using scan_cell_common::Grid;
using scan_cell_common::GridEntry;

constexpr double kMaxCells = 1 << 20;  // a part of 2 m has 4000 cells of 0.5 mm; chosen

auto positions_of(const scan_cell_common::Cloud& cloud) {
  return [&cloud](std::size_t i) -> Eigen::Vector3d {
    return cloud[i].getVector3fMap().cast<double>();
  };
}

std::vector<GridEntry> sorted(const scan_cell_common::Cloud& cloud, const Grid& grid) {
  return scan_cell_common::sort_into_grid(cloud.size(), positions_of(cloud), grid);
}

GridCells cells_of(const scan_cell_common::Cloud& cloud, const std::vector<GridEntry>& entries) {
  GridCells cells;
  cells.cell_of_point.resize(cloud.size());
  for_each_cell(entries, [&, position = positions_of(cloud)](auto begin, auto end) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (auto each = begin; each != end; ++each) {
      sum += position(each->point);
      cells.cell_of_point[each->point] = static_cast<std::uint32_t>(cells.means.size());
    }
    const Eigen::Vector3f mean = (sum / static_cast<double>(end - begin)).cast<float>();
    cells.means.push_back({mean.x(), mean.y(), mean.z()});
  });
  return cells;
}

Grid grid_of(const Eigen::Vector3d& leaf) {
  return {leaf, {2, 1, 0}, kMaxCells};
}

}  // namespace

GridCells sort_into_grid(const scan_cell_common::Cloud& cloud, const Eigen::Vector3d& leaf) {
  return cells_of(cloud, sorted(cloud, grid_of(leaf)));
}

GridCells sort_into_even_grid(const scan_cell_common::Cloud& cloud, const Eigen::Vector3d& leaf) {
  const Grid grid = grid_of(leaf);
  return cells_of(cloud, with_even_cells(sorted(cloud, grid), positions_of(cloud), grid));
}

}  // namespace cloud_preprocess
