// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/clusters.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "scan_cell_common/geometry/grid.h"

namespace cloud_preprocess {
namespace {

using scan_cell_common::Cloud;
using scan_cell_common::GridEntry;
using Index = KdTree::Index;

/// Points in one cell of the grid, all closer to each other than the gap.
struct Cell {
  std::size_t begin, end;  // of its entries
  Eigen::AlignedBox3f box;
};

std::vector<GridEntry> sorted_by_cell(const Cloud& points, double gap) {
  constexpr double kInside = 0.9999;  // of the gap, for the cell's diagonal; for the rounding
  constexpr double kMaxCells = 1e15;  // Grid's own limit
  const double leaf = kInside * gap / std::sqrt(3.0);
  const auto place = [&points](std::size_t i) -> Eigen::Vector3d {
    return points[i].getVector3fMap().cast<double>();
  };
  return scan_cell_common::sort_into_grid(points.size(), place,
                                          {Eigen::Vector3d::Constant(leaf), {2, 1, 0}, kMaxCells});
}

std::vector<Cell> boxed_cells(const Cloud& points, const std::vector<GridEntry>& entries) {
  std::vector<Cell> cells;
  for_each_cell(entries, [&, first = entries.begin()](auto begin, auto end) {
    Cell& cell = cells.emplace_back();
    cell.begin = static_cast<std::size_t>(begin - first);
    cell.end = static_cast<std::size_t>(end - first);
    for (auto each = begin; each != end; ++each)
      cell.box.extend(points[each->point].getVector3fMap());
  });
  return cells;
}

Cloud middles_of(const std::vector<Cell>& cells) {
  Cloud middles;
  for (const Cell& cell : cells) {
    const Eigen::Vector3f middle = cell.box.center();
    middles.push_back({middle.x(), middle.y(), middle.z()});
  }
  return middles;
}

/// Grows clusters cell by cell. A search around each point would visit all points within the gap,
/// which may be hundreds.
class LinkedCells {
 public:
  LinkedCells(const Cloud& points, double gap)
      : points_(points),
        squared_gap_(static_cast<float>(gap * gap)),
        entries_(sorted_by_cell(points, gap)),
        cells_(boxed_cells(points, entries_)),
        middles_(middles_of(cells_)),
        tree_(middles_),
        cell_of_(points.size()),
        taken_(cells_.size(), false) {
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
      for (std::size_t i = cells_[cell].begin; i < cells_[cell].end; ++i)
        cell_of_[entries_[i].point] = static_cast<Index>(cell);
  }

  bool is_taken(Index point) const { return taken_[cell_of_[point]]; }

  /// Takes all cells that are linked to this point's.
  std::vector<Index> take(Index start) {
    std::vector<Index> cells{cell_of_[start]};
    taken_[cells.front()] = true;
    std::vector<Index> cluster;
    std::vector<std::pair<Index, float>> near;
    for (std::size_t next = 0; next < cells.size(); ++next) {
      const Cell& cell = cells_[cells[next]];
      for (std::size_t i = cell.begin; i < cell.end; ++i)
        cluster.push_back(entries_[i].point);
      constexpr float kReach = 4.5F;  // square of two half diagonals and a gap; .5 for the rounding
      tree_.within(middles_[cells[next]].data, kReach * squared_gap_, near);
      for (const auto& [other, squared] : near) {
        if (taken_[other] || !are_linked(cell, cells_[other])) continue;
        taken_[other] = true;
        cells.push_back(other);
      }
    }
    return cluster;
  }

 private:
  Eigen::Vector3f place(std::size_t entry) const {
    return points_[entries_[entry].point].getVector3fMap();
  }

  /// Whether any two of their points are closer than the gap.
  bool are_linked(const Cell& one, const Cell& other) const {
    if (one.box.squaredExteriorDistance(other.box) >= squared_gap_) return false;
    for (std::size_t i = one.begin; i < one.end; ++i) {
      const Eigen::Vector3f from = place(i);
      if (other.box.squaredExteriorDistance(from) >= squared_gap_) continue;
      for (std::size_t j = other.begin; j < other.end; ++j)
        if ((place(j) - from).squaredNorm() < squared_gap_) return true;
    }
    return false;
  }

  const Cloud& points_;
  const float squared_gap_;               // [m^2]
  const std::vector<GridEntry> entries_;  // sorted by cell
  const std::vector<Cell> cells_;
  const Cloud middles_;  // one per cell
  const KdTree tree_;
  std::vector<Index> cell_of_;  // one per point
  std::vector<bool> taken_;
};

}  // namespace

std::vector<Index> cluster_of(const Cloud& points, double gap, Index start) {
  return LinkedCells(points, gap).take(start);
}

std::vector<std::vector<Index>> clusters(const Cloud& points, double gap) {
  LinkedCells cells(points, gap);
  std::vector<std::vector<Index>> found;
  for (Index start = 0; start < points.size(); ++start) {
    if (cells.is_taken(start)) continue;
    found.push_back(cells.take(start));
    std::sort(found.back().begin(), found.back().end());
  }
  return found;
}

}  // namespace cloud_preprocess
