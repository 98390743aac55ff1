// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cloud.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace laser_triangulation {

using scan_cell_common::CloudField;
using scan_cell_common::FieldType;

std::vector<CloudField> scan_point_fields() {
  return {{"x", FieldType::kFloat32, offsetof(ScanPoint, x)},
          {"y", FieldType::kFloat32, offsetof(ScanPoint, y)},
          {"z", FieldType::kFloat32, offsetof(ScanPoint, z)},
          {"intensity", FieldType::kFloat32, offsetof(ScanPoint, intensity)},
          {"laser", FieldType::kUint8, offsetof(ScanPoint, laser)},
          {"pass", FieldType::kUint8, offsetof(ScanPoint, pass)},
          {"width", FieldType::kFloat32, offsetof(ScanPoint, width)},
          {"vp_x", FieldType::kFloat32, offsetof(ScanPoint, vp_x)},
          {"vp_y", FieldType::kFloat32, offsetof(ScanPoint, vp_y)},
          {"vp_z", FieldType::kFloat32, offsetof(ScanPoint, vp_z)}};
}

void ScanCloud::append(const std::vector<ScanPoint>& points) {
  for (auto next = points.begin(); next != points.end();) {
    if (blocks_.empty() || blocks_.back().size() == kBlock) {
      blocks_.emplace_back();
      blocks_.back().reserve(kBlock);
    }
    std::vector<ScanPoint>& block = blocks_.back();
    const std::size_t room = kBlock - block.size();
    const auto end =
        next + std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(room), points.end() - next);
    block.insert(block.end(), next, end);
    next = end;
  }
  size_ += points.size();
}

void ScanCloud::copy(std::size_t first, std::uint8_t* bytes) const {
  std::size_t skipped = first % kBlock;
  for (std::size_t i = first / kBlock; i < blocks_.size(); ++i) {
    const std::size_t size = (blocks_[i].size() - skipped) * sizeof(ScanPoint);
    if (size > 0) std::memcpy(bytes, &blocks_[i][skipped], size);
    bytes += size;
    skipped = 0;
  }
}

}  // namespace laser_triangulation
