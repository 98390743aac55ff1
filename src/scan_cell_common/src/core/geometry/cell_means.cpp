// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/geometry/cell_means.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace scan_cell_common {
namespace {

constexpr double kSame = 0.5;    // of a cell between two means across their border; chosen
constexpr double kBeside = 0.3;  // of a cell between them along it: noise moves none there; chosen
constexpr double kThin = 0.23;   // of a cell, deviation of its points: 0.29 fill it; chosen
constexpr double kBroad = 0.15;  // of a cell, deviation of points of a surface along it; chosen
constexpr double kFew = 0.2;     // of the neighbour's points: what noise carries over; chosen

/// Finds for each cell the one that it goes with.
class Joiner {
 public:
  Joiner(const std::vector<CellSum>& cells, const Grid& grid)
      : cells_(cells),
        grid_(grid),
        with_(cells.size()),
        nearest_(cells.size(), std::numeric_limits<double>::infinity()) {
    std::iota(with_.begin(), with_.end(), 0);
    for (std::size_t axis = 0; axis < 3; ++axis)
      look_along(axis);
  }

  /// The cell in which all that hangs together with a cell is gathered.
  std::uint32_t root(std::uint32_t cell) const {
    while (with_[cell] != cell)
      cell = with_[cell];
    return cell;
  }

 private:
  /// Adding one to all cells keeps their order, so their neighbours come in that order, too.
  void look_along(std::size_t axis) {
    std::size_t other = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      auto wanted = cells_[i].cell;
      ++wanted[axis];
      while (other < cells_.size() && cells_[other].cell < wanted)
        ++other;
      if (other == cells_.size()) return;
      if (cells_[other].cell == wanted)
        meet(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(other), grid_.axes[axis]);
    }
  }

  /// The one with fewer points may go with the other; of several others with the one that is
  /// nearest along the axis on which they are neighbours.
  void meet(std::uint32_t one, std::uint32_t other, int axis) {
    if (cells_[one].count > cells_[other].count) std::swap(one, other);
    Eigen::Vector3d off = (mean_of(one) - mean_of(other)).cwiseQuotient(grid_.leaf);
    const double distance = std::abs(off[axis]);
    off[axis] = 0;
    if (deviation_of(other)[axis] > kThin * grid_.leaf[axis]) return;
    const bool few = cells_[one].count < kFew * cells_[other].count;
    const bool same = distance < kSame && off.norm() < kBeside && is_broad(one, axis);
    if (!(few && distance < 1) && !same) return;
    if (distance >= nearest_[one]) return;
    nearest_[one] = distance;
    with_[one] = other;
  }

  /// Whether the points spread along the border: a wall that ends there does not.
  bool is_broad(std::uint32_t cell, int across) const {
    Eigen::Vector3d spread = deviation_of(cell).cwiseQuotient(grid_.leaf);
    spread[across] = 1;
    return spread.minCoeff() > kBroad;
  }

  Eigen::Vector3d deviation_of(std::uint32_t cell) const {
    const Eigen::Vector3d mean = mean_of(cell);
    return (cells_[cell].squares / cells_[cell].count - mean.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
  }

  Eigen::Vector3d mean_of(std::uint32_t cell) const {
    return cells_[cell].sum / cells_[cell].count;
  }

  const std::vector<CellSum>& cells_;
  const Grid& grid_;
  std::vector<std::uint32_t> with_;  // itself: it stays
  std::vector<double> nearest_;
};

}  // namespace

CellMeans joined_means(const std::vector<CellSum>& cells, const Grid& grid) {
  const Joiner joiner(cells, grid);
  std::vector<CellSum> joined = cells;
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    const std::uint32_t root = joiner.root(i);
    if (root == i) continue;
    joined[root].sum += cells[i].sum;
    joined[root].count += cells[i].count;
  }
  CellMeans result;
  result.mean_of_cell.resize(cells.size());
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    if (joiner.root(i) != i) continue;
    result.mean_of_cell[i] = static_cast<std::uint32_t>(result.means.size());
    result.means.push_back(joined[i].sum / joined[i].count);
  }
  for (std::uint32_t i = 0; i < cells.size(); ++i)
    result.mean_of_cell[i] = result.mean_of_cell[joiner.root(i)];
  return result;
}

}  // namespace scan_cell_common
