// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_file.h"

#include <algorithm>
#include <fstream>

#include "scan_cell_common/files/files.h"

namespace laser_triangulation {

namespace {

/// Writes in chunks: the cloud may take most of the memory.
void write_ply(const ScanCloud& points, double metres_per_unit, std::ostream& file) {
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << points.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nproperty float intensity\n"
          "property uchar laser\nproperty uchar pass\nproperty float width\nend_header\n";
  constexpr std::size_t kAtOnce = 65536;
  std::string bytes;
  const auto append = [&bytes](const auto& field) {
    bytes.append(reinterpret_cast<const char*>(&field), sizeof(field));
  };
  for (std::size_t first = 0; first < points.size() && file; first += kAtOnce) {
    bytes.clear();
    for (std::size_t i = first; i < std::min(first + kAtOnce, points.size()); ++i) {
      const ScanPoint& point = points[i];
      for (const float metres : {point.x, point.y, point.z})
        append(static_cast<float>(static_cast<double>(metres) / metres_per_unit));
      append(point.intensity);
      append(point.laser);
      append(point.pass);
      append(point.width);
    }
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
}

}  // namespace

void check_ply_output(const std::string& path) {
  scan_cell_common::check_output(path, {".ply"}, "write scans as .ply");
}

void save_ply(const std::string& path, const ScanCloud& points, double metres_per_unit) {
  check_ply_output(path);
  scan_cell_common::save_whole(path, [&](const std::string& partial) {
    std::ofstream file(partial, std::ios::binary);
    write_ply(points, metres_per_unit, file);
    file.close();
    return !file.fail();
  });
}

}  // namespace laser_triangulation
