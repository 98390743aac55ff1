// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/grid_reduction.h"

#include <cstdint>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/grid_cells.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace cloud_preprocess {
namespace {

/// For each cell, the point nearest to its mean; the first if several are equally near.
std::vector<std::uint32_t> nearest_to_means(const GridCells& grid, const Cloud& points) {
  std::vector<std::uint32_t> nearest(grid.means.size());
  std::vector<float> distances(grid.means.size(), std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t cell = grid.cell_of_point[i];
    const float distance =
        (points[i].getVector3fMap() - grid.means[cell].getVector3fMap()).squaredNorm();
    if (distance >= distances[cell]) continue;
    distances[cell] = distance;
    nearest[cell] = static_cast<std::uint32_t>(i);
  }
  return nearest;
}

}  // namespace

void describe(scan_cell_common::ParameterTable& table, GridParameters& parameters) {
  table.add("leaf", parameters.leaf, {1e-5, 1, "m"}, "size of a cell along x, y, z");
}

GridReduction::GridReduction(const GridParameters& parameters) : parameters_(parameters) {
  scan_cell_common::check(parameters_);
}

std::string GridReduction::apply(TracedCloud& cloud) const {
  const Eigen::Vector3d& leaf = parameters_.leaf;
  GridCells grid = sort_into_even_grid(cloud.cloud(), leaf);
  const std::vector<std::uint32_t> nearest = nearest_to_means(grid, cloud.cloud());
  cloud.replace(std::move(grid.means), nearest);
  char text[80];
  std::snprintf(text, sizeof(text), "one point a cell of %g x %g x %g mm", leaf.x() * 1e3,
                leaf.y() * 1e3, leaf.z() * 1e3);
  return text;
}

}  // namespace cloud_preprocess
