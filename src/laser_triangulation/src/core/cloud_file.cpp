// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_file.h"

#include "scan_cell_common/files/files.h"

namespace laser_triangulation {

void check_ply_output(const std::string& path) {
  scan_cell_common::check_output(path, {".ply"}, "write scans as .ply");
}

void save_ply(const std::string& path, const ScanCloud& points, double metres_per_unit) {
  check_ply_output(path);
  const auto at = [&points](std::size_t index) {
    return reinterpret_cast<const std::uint8_t*>(&points[index]);
  };
  scan_cell_common::save_cloud(path, scan_point_fields(), points.size(), at, metres_per_unit);
}

}  // namespace laser_triangulation
