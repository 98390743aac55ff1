// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan_cell_common/clouds/cloud_files.h"

namespace scan_cell_common {

/// Writes the points' coordinates as binary PLY. False if that failed.
bool write_ply(const std::string& path, const Cloud& cloud);

/// The same as binary PCD (version 0.7); an organised cloud keeps its width and height.
bool write_pcd(const std::string& path, const Cloud& cloud);

}  // namespace scan_cell_common
