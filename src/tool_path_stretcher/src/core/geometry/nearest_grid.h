// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

#include "geometry/kd_tree.h"

namespace tool_path_stretcher {

/// Nearest points of a fixed set, to within the size of a cell. For each cell of space, the point
/// nearest to its centre is looked up once, on first use. Far cheaper than a tree for poses that
/// are only roughly right. Thread-safe.
class NearestGrid {
 public:
  /// The set must not be empty.
  explicit NearestGrid(Points points) : tree_(std::move(points)) {
    constexpr double kCells = 50;     // along the longest side; chosen
    constexpr double kMargin = 0.25;  // of the longest side; chosen
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& point : tree_.points())
      box.extend(point);
    const double longest = box.sizes().maxCoeff();
    edge_ = longest > 0 ? longest / kCells : 1;
    corner_ = box.min() - Eigen::Vector3d::Constant(kMargin * longest);
    const Eigen::Vector3d sizes = box.sizes() + Eigen::Vector3d::Constant(2 * kMargin * longest);
    counts_ = (sizes / edge_).array().ceil().cast<int>().max(1);
    known_ = std::vector<std::atomic<std::uint32_t>>(static_cast<std::size_t>(counts_.x()) *
                                                     static_cast<std::size_t>(counts_.y()) *
                                                     static_cast<std::size_t>(counts_.z()));
  }

  const Points& points() const { return tree_.points(); }

  std::size_t nearest(const Eigen::Vector3d& query) {
    const Eigen::Array3i at = cell_of(query);
    std::atomic<std::uint32_t>& known =
        known_[static_cast<std::size_t>((at.z() * counts_.y() + at.y()) * counts_.x() + at.x())];
    // Two threads that both miss find the same point.
    std::uint32_t number = known.load(std::memory_order_relaxed);
    if (number == kUnknown) {
      number = 1 + static_cast<std::uint32_t>(
                       tree_.nearest(corner_ + edge_ * (at.cast<double>() + 0.5).matrix()).index);
      known.store(number, std::memory_order_relaxed);
    }
    return number - 1;
  }

 private:
  static constexpr std::uint32_t kUnknown = 0;

  /// The border cell for queries outside; the first cell for NaN.
  Eigen::Array3i cell_of(const Eigen::Vector3d& query) const {
    Eigen::Array3i cell;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double at = (query[axis] - corner_[axis]) / edge_;
      cell[axis] = at > 0 ? static_cast<int>(std::min(at, counts_[axis] - 1.0)) : 0;
    }
    return cell;
  }

  KdTree tree_;
  Eigen::Vector3d corner_;
  double edge_;
  Eigen::Array3i counts_;
  std::vector<std::atomic<std::uint32_t>> known_;  // of each cell: the point's index + 1
};

}  // namespace tool_path_stretcher
