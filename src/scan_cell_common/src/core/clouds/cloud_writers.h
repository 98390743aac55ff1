// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell_common/clouds/fielded_cloud.h"

namespace scan_cell_common {

/// Points anywhere in memory.
struct PointsToWrite {
  std::vector<CloudField> fields;
  std::size_t width = 0;
  std::size_t height = 1;
  PointAt at;
};

/// Writes every cloud of the suite.
/// @throw FileError if the file cannot be written or its extension is neither .ply nor .pcd
void write_cloud(const std::string& path, const PointsToWrite& points, double metres_per_unit);

/// @throw UnusableInput naming the one of x, y and z that is missing or not float32
void check_coordinates(const std::vector<CloudField>& fields);

/// Prefixes of the fields of a place, which have the unit and the frame of x, y and z.
const std::vector<std::string>& place_prefixes();

}  // namespace scan_cell_common
