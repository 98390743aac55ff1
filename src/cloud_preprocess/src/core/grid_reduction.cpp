// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/grid_reduction.h"

#include <cstdio>

#include "geometry/grid_cells.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace cloud_preprocess {

void describe(scan_cell_common::ParameterTable& table, GridParameters& parameters) {
  table.add("leaf", parameters.leaf, {1e-5, 1, "m"}, "size of a cell along x, y, z");
}

GridReduction::GridReduction(const GridParameters& parameters) : parameters_(parameters) {
  scan_cell_common::check(parameters_);
}

std::string GridReduction::apply(Cloud& cloud) const {
  const Eigen::Vector3d& leaf = parameters_.leaf;
  cloud = sort_into_grid(cloud, leaf).means;
  char text[80];
  std::snprintf(text, sizeof(text), "one point a cell of %g x %g x %g mm", leaf.x() * 1e3,
                leaf.y() * 1e3, leaf.z() * 1e3);
  return text;
}

}  // namespace cloud_preprocess
