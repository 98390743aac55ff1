// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "laser_triangulation/triangulator.h"
#include "scan_cell_common/clouds/fielded_cloud.h"

namespace laser_triangulation {

/// The fields of a ScanPoint, as named in messages and files.
std::vector<scan_cell_common::CloudField> scan_point_fields();

/// The points of a scan, in blocks. Unlike a vector, it grows without copying, and takes no more
/// memory than the points.
class ScanCloud {
 public:
  /// Appends points.
  void append(const std::vector<ScanPoint>& points);

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const ScanPoint& operator[](std::size_t index) const {
    return blocks_[index / kBlock][index % kBlock];
  }

  /// Calls change(point) for each point.
  template <class Change>
  void for_each(const Change& change) {
    for (std::vector<ScanPoint>& block : blocks_) {
      for (ScanPoint& point : block)
        change(point);
    }
  }

  /// Copies the points from `first` to the end, as they lie in memory.
  void copy(std::size_t first, std::uint8_t* bytes) const;

 private:
  static constexpr std::size_t kBlock = 65536;  // points; chosen

  std::vector<std::vector<ScanPoint>> blocks_;  // all full except the last
  std::size_t size_ = 0;
};

}  // namespace laser_triangulation
