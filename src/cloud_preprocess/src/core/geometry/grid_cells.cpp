// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/grid_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scan_cell_common/errors.h"

namespace cloud_preprocess {
namespace {

constexpr int kBits = 21;  // an axis: three of them fit into the 64 bits of a key
constexpr double kMostCells = 1 << (kBits - 1);

std::uint64_t axis_key(double coordinate, double leaf) {
  const double cell = std::floor(coordinate / leaf);
  if (!(std::abs(cell) < kMostCells)) {
    throw scan_cell_common::UnusableInput(
        "point", "at " + std::to_string(coordinate) + " m, beyond a million cells",
        "remove outliers first, set limits, or take larger cells");
  }
  return static_cast<std::uint64_t>(cell + kMostCells);
}

std::uint64_t key(const pcl::PointXYZ& point, const Eigen::Vector3d& leaf) {
  return axis_key(point.z, leaf.z()) << (2 * kBits) | axis_key(point.y, leaf.y()) << kBits |
         axis_key(point.x, leaf.x());
}

}  // namespace

GridCells sort_into_grid(const scan_cell_common::Cloud& cloud, const Eigen::Vector3d& leaf) {
  using KeyedPoint = std::pair<std::uint64_t, std::uint32_t>;
  std::vector<KeyedPoint> sorted(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    sorted[i] = {key(cloud[i], leaf), static_cast<std::uint32_t>(i)};
  }
  std::sort(sorted.begin(), sorted.end());  // by the point's index within a cell: one order of sums

  GridCells cells;
  cells.cell_of_point.resize(cloud.size());
  for (auto first = sorted.begin(); first != sorted.end();) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    auto last = first;
    for (; last != sorted.end() && last->first == first->first; ++last) {
      sum += cloud[last->second].getVector3fMap().cast<double>();
      cells.cell_of_point[last->second] = static_cast<std::uint32_t>(cells.means.size());
    }
    const Eigen::Vector3f mean = (sum / static_cast<double>(last - first)).cast<float>();
    cells.means.push_back({mean.x(), mean.y(), mean.z()});
    first = last;
  }
  return cells;
}

}  // namespace cloud_preprocess
