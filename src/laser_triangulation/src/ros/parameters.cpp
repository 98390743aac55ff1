// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.h"

#include <filesystem>

#include "scan_cell_common/parameters/parameter_table.h"

namespace laser_triangulation {

void describe(scan_cell_common::ParameterTable& table, Parameters& parameters) {
  table.require("scanner", parameters.scanner, "path of the scanner model");
  describe(table, parameters.limits);
  table.add("publish_rate", parameters.publish_rate, {0.1, 100, "Hz"},
            "of `~cloud`; a point waits for up to one period. Lower it if a viewer that keeps many "
            "clouds becomes slow");
  table.add("max_points", parameters.max_points, {1000, 2e8},
            "largest number of points in a scan (36 bytes each)");
  table.renamed("most_points", "max_points");
  table.add("max_message_points", parameters.max_message_points, {1, 2.7e7},
            "a cloud with more is written to a file: roscpp carries no message above 1 GB, 27.7 "
            "million points");
  table.renamed("most_message_points", "max_message_points");
  table.add("cloud_folder", parameters.cloud_folder,
            "existing folder for these files; `.` of a launched node is `~/.ros`");
  if (!std::filesystem::is_directory(parameters.cloud_folder))
    table.refuse("cloud_folder", "'" + parameters.cloud_folder + "'", "give a folder that exists");
}

}  // namespace laser_triangulation
