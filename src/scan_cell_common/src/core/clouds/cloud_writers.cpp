// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/cloud_writers.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <vector>

// PCL's writers would bring VTK and OpenNI to whoever reads or writes a cloud.

namespace scan_cell_common {
namespace {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "both formats are written as they lie");

bool write(const std::string& path, const std::string& header, const Cloud& cloud) {
  std::ofstream file(path, std::ios::binary);
  file << header;
  constexpr std::size_t kPointsAtOnce = 65536;
  std::vector<std::array<float, 3>> points;
  for (std::size_t begin = 0; begin < cloud.size(); begin += kPointsAtOnce) {
    points.clear();
    const std::size_t end = std::min(begin + kPointsAtOnce, cloud.size());
    for (std::size_t i = begin; i < end; ++i)
      points.push_back({cloud[i].x, cloud[i].y, cloud[i].z});
    file.write(reinterpret_cast<const char*>(points.data()),
               static_cast<std::streamsize>(points.size() * sizeof(points[0])));
  }
  file.flush();
  return file.good();
}

}  // namespace

bool write_ply(const std::string& path, const Cloud& cloud) {
  std::ostringstream header;
  header << "ply\nformat binary_little_endian 1.0\nelement vertex " << cloud.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  return write(path, header.str(), cloud);
}

bool write_pcd(const std::string& path, const Cloud& cloud) {
  const bool organised = std::size_t{cloud.width} * cloud.height == cloud.size();
  std::ostringstream header;
  header << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\n"
            "TYPE F F F\nCOUNT 1 1 1\nWIDTH "
         << (organised ? cloud.width : cloud.size()) << "\nHEIGHT "
         << (organised ? cloud.height : 1) << "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << cloud.size()
         << "\nDATA binary\n";
  return write(path, header.str(), cloud);
}

}  // namespace scan_cell_common
