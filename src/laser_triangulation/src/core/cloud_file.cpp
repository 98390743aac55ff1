// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_triangulation/cloud_file.h"

#include <filesystem>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/yaml_file.h"

namespace laser_triangulation {

void save_ply(const std::string& path, const std::vector<ScanPoint>& points) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".ply") {
    throw scan_cell_common::FileError(path, "ending '" + extension + "'", "write scans as .ply");
  }
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(points.size()) +
      "\nproperty float x\nproperty float y\nproperty float z\nproperty float intensity\n"
      "property uchar laser\nend_header\n";
  constexpr std::size_t kPointSize = 17;  // without the padding
  bytes.reserve(bytes.size() + points.size() * kPointSize);
  for (const ScanPoint& point : points)
    bytes.append(reinterpret_cast<const char*>(&point), kPointSize);
  scan_cell_common::save_text(path, bytes);
}

}  // namespace laser_triangulation
