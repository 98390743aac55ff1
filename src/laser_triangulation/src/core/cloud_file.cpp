// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_triangulation/cloud_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/files.h"

namespace laser_triangulation {

namespace {

/// Some points at a time: the cloud may take most of the memory.
void write_ply(const ScanCloud& points, std::ostream& file) {
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << points.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nproperty float intensity\n"
          "property uchar laser\nproperty float width\nend_header\n";
  constexpr std::size_t kAtOnce = 65536;
  std::string bytes;
  const auto append = [&bytes](const auto& field) {
    bytes.append(reinterpret_cast<const char*>(&field), sizeof(field));
  };
  for (std::size_t first = 0; first < points.size() && file; first += kAtOnce) {
    bytes.clear();
    for (std::size_t i = first; i < std::min(first + kAtOnce, points.size()); ++i) {
      const ScanPoint& point = points[i];
      append(point.x);
      append(point.y);
      append(point.z);
      append(point.intensity);
      append(point.laser);
      append(point.width);
    }
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
}

}  // namespace

void save_ply(const std::string& path, const ScanCloud& points) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".ply") {
    throw scan_cell_common::FileError(path, "ending '" + extension + "'", "write scans as .ply");
  }
  scan_cell_common::save_whole(path, [&points](const std::string& partial) {
    std::ofstream file(partial, std::ios::binary);
    write_ply(points, file);
    file.close();
    return !file.fail();
  });
}

}  // namespace laser_triangulation
