// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "laser_triangulation/scan_cloud.h"

namespace laser_triangulation {

/// Writes binary PLY with x, y, z, intensity (float), laser (uchar) and width (float), whole or not
/// at all.
/// @throw scan_cell_common::FileError if it cannot be written or the ending is not .ply
void save_ply(const std::string& path, const ScanCloud& points);

}  // namespace laser_triangulation
