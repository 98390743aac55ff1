// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/geometry/even_cells.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace scan_cell_common {
namespace {

using Position = std::function<Eigen::Vector3d(std::size_t)>;

constexpr double kSame = 0.5;    // of a cell, between two means across their border; chosen
constexpr double kBeside = 0.3;  // of a cell, between them along it, where noise moves none; chosen
constexpr double kThin = 0.23;   // of a cell, deviation of its points; 0.29 fills it; chosen
constexpr double kBroad = 0.15;  // of a cell, deviation of points of a surface along it; chosen
constexpr double kFlat = 0.02;   // of a cell: no deviation except rounding; chosen
constexpr double kUneven = 4;    // ratio of two deviations; noise cut in two has up to 3; chosen
constexpr std::size_t kLeast = 9;  // places in both; fewer tell little about the spread; chosen
constexpr double kFew = 0.2;  // of the neighbour's points: share that noise carries over; chosen

/// The entries of a cell, and statistics of their points.
struct FilledCell {
  std::size_t begin, end;
  std::size_t places;         // distinct positions: copies of a point add no information
  Eigen::Vector3d mean;       // [m]
  Eigen::Vector3d deviation;  // [m]

  std::size_t count() const { return end - begin; }
};

std::size_t places_of(std::vector<Eigen::Vector3d>& points) {
  const auto before = [](const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
    return std::lexicographical_compare(one.begin(), one.end(), other.begin(), other.end());
  };
  std::sort(points.begin(), points.end(), before);
  const auto end = std::unique(points.begin(), points.end());
  return static_cast<std::size_t>(end - points.begin());
}

FilledCell filled(const std::vector<GridEntry>& entries, std::size_t begin, std::size_t end,
                  const Position& position) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = begin; i != end; ++i)
    points.push_back(position(entries[i].point));
  const double count = static_cast<double>(end - begin);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points)
    mean += point / count;
  Eigen::Vector3d variance = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points)
    variance += (point - mean).cwiseAbs2() / count;
  return {begin, end, places_of(points), mean, variance.cwiseSqrt()};
}

/// Finds for each cell the one that it joins.
class Joiner {
 public:
  Joiner(const std::vector<GridEntry>& entries, const Position& position, const Grid& grid)
      : entries_(entries), grid_(grid) {
    const auto first = entries.begin();
    for_each_cell(entries, [&](auto begin, auto end) {
      cells_.push_back(filled(entries, static_cast<std::size_t>(begin - first),
                              static_cast<std::size_t>(end - first), position));
    });
    with_.resize(cells_.size());
    std::iota(with_.begin(), with_.end(), 0);
    nearest_.assign(cells_.size(), std::numeric_limits<double>::infinity());
    for (std::size_t axis = 0; axis < 3; ++axis)
      look_along(axis);
  }

  /// The cells of each piece that lies in more than one, in order.
  std::vector<std::vector<FilledCell>> pieces() const {
    std::map<std::size_t, std::vector<FilledCell>> pieces;
    for (std::size_t i = 0; i < cells_.size(); ++i)
      if (with_[i] != i) pieces[root(i)];
    std::vector<std::vector<FilledCell>> listed;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const auto piece = pieces.find(root(i));
      if (piece != pieces.end()) piece->second.push_back(cells_[i]);
    }
    for (auto& [root, piece] : pieces)
      listed.push_back(std::move(piece));
    return listed;
  }

 private:
  std::size_t root(std::size_t cell) const {
    while (with_[cell] != cell)
      cell = with_[cell];
    return cell;
  }

  /// Adding one to all cells keeps their order, so their neighbours are in the same order.
  void look_along(std::size_t axis) {
    std::size_t other = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      auto wanted = number(i);
      ++wanted[axis];
      while (other < cells_.size() && number(other) < wanted)
        ++other;
      if (other == cells_.size()) return;
      if (number(other) == wanted) meet(i, other, grid_.axes[axis]);
    }
  }

  /// The cell with fewer points may join the other; of several others, the one nearest along the
  /// axis on which they are neighbours.
  void meet(std::size_t one, std::size_t other, int axis) {
    if (cells_[one].count() > cells_[other].count()) std::swap(one, other);
    const FilledCell& fuller = cells_[other];
    const auto [thinner, thicker] =
        std::minmax(fuller.deviation[axis], cells_[one].deviation[axis]);
    if (thicker > kThin * grid_.leaf[axis]) return;
    if (fuller.places + cells_[one].places < kLeast) return;
    Eigen::Vector3d off = (cells_[one].mean - fuller.mean).cwiseQuotient(grid_.leaf);
    const double distance = std::abs(off[axis]);
    off[axis] = 0;
    const bool few =
        static_cast<double>(cells_[one].count()) < kFew * static_cast<double>(fuller.count());
    const bool same = distance < kSame && off.norm() < kBeside && is_broad(cells_[one], axis) &&
                      thicker <= std::max(kUneven * thinner, kFlat * grid_.leaf[axis]);
    if (!(few && distance < 1) && !same) return;
    if (distance >= nearest_[one]) return;
    nearest_[one] = distance;
    with_[one] = other;
  }

  /// Whether the points spread along the border: a wall that ends there does not.
  bool is_broad(const FilledCell& cell, int across) const {
    Eigen::Vector3d spread = cell.deviation.cwiseQuotient(grid_.leaf);
    spread[across] = 1;
    return spread.minCoeff() > kBroad;
  }

  const std::array<std::int64_t, 3>& number(std::size_t cell) const {
    return entries_[cells_[cell].begin].cell;
  }

  const std::vector<GridEntry>& entries_;
  const Grid& grid_;
  std::vector<FilledCell> cells_;
  std::vector<std::size_t> with_;  // its own index: it stays alone
  std::vector<double> nearest_;
};

/// @param cells of one piece
void deal(const std::vector<FilledCell>& cells, const Position& position,
          std::vector<GridEntry>& entries) {
  std::vector<GridEntry*> places;
  std::vector<std::pair<Eigen::Vector3d, std::uint32_t>> points;
  Eigen::AlignedBox3d box;
  for (const FilledCell& cell : cells) {
    for (std::size_t i = cell.begin; i != cell.end; ++i) {
      places.push_back(&entries[i]);
      points.emplace_back(position(entries[i].point), entries[i].point);
      box.extend(points.back().first);
    }
  }
  int along = 0;
  box.sizes().maxCoeff(&along);
  std::sort(points.begin(), points.end(), [along](const auto& one, const auto& other) {
    return std::pair(one.first[along], one.second) < std::pair(other.first[along], other.second);
  });
  std::vector<std::array<std::int64_t, 3>> numbers;
  for (const FilledCell& cell : cells)
    numbers.push_back(entries[cell.begin].cell);
  for (std::size_t first = 0, next = 0; first < points.size(); first = next) {
    while (next < points.size() && points[next].first[along] == points[first].first[along])
      ++next;  // points in one place along stay together, where their middle belongs
    const std::size_t cell = (first + next) * cells.size() / (2 * points.size());
    for (std::size_t i = first; i < next; ++i)
      *places[i] = {numbers[cell], points[i].second};
  }
}

}  // namespace

std::vector<GridEntry> with_even_cells(std::vector<GridEntry> entries, const Position& position,
                                       const Grid& grid) {
  for (const std::vector<FilledCell>& piece : Joiner(entries, position, grid).pieces())
    deal(piece, position, entries);
  std::sort(entries.begin(), entries.end());
  return entries;
}

}  // namespace scan_cell_common
