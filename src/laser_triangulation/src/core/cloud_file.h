// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan_cloud.h"

namespace laser_triangulation {

/// Writes binary PLY with the scan_point_fields(), whole or not at all.
/// @param metres_per_unit of x, y, z in the file
/// @throw scan_cell_common::FileError if it cannot be written or the extension is not .ply
void save_ply(const std::string& path, const ScanCloud& points, double metres_per_unit = 1);

/// Throws what save_ply() would throw for this path, before there is anything to save.
/// @throw scan_cell_common::FileError if the extension is not .ply, or the folder does not exist
void check_ply_output(const std::string& path);

}  // namespace laser_triangulation
