// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/picks_file.h"

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/files/files.h"
#include "tool_path_stretcher/surface.h"

namespace part_recipes {

path_design::Points load_picks(const std::string& file, double metres_per_unit) {
  const auto table =
      scan_cell_common::parse_point_table(scan_cell_common::read_file(file), file, metres_per_unit);
  path_design::Points picks = tool_path_stretcher::to_points(table.cloud);
  for (Eigen::Vector3d& pick : picks)
    pick *= metres_per_unit;
  return picks;
}

}  // namespace part_recipes
