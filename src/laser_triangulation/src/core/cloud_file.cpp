// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_triangulation/cloud_file.h"

#include <filesystem>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/yaml_file.h"

namespace laser_triangulation {

void save_ply(const std::string& path, const ScanCloud& points) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".ply") {
    throw scan_cell_common::FileError(path, "ending '" + extension + "'", "write scans as .ply");
  }
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(points.size()) +
      "\nproperty float x\nproperty float y\nproperty float z\nproperty float intensity\n"
      "property uchar laser\nproperty float width\nend_header\n";
  constexpr std::size_t kPointSize = 21;  // without the padding
  bytes.reserve(bytes.size() + points.size() * kPointSize);
  const auto append = [&bytes](const auto& field) {
    bytes.append(reinterpret_cast<const char*>(&field), sizeof(field));
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ScanPoint& point = points[i];
    append(point.x);
    append(point.y);
    append(point.z);
    append(point.intensity);
    append(point.laser);
    append(point.width);
  }
  scan_cell_common::save_text(path, bytes);
}

}  // namespace laser_triangulation
