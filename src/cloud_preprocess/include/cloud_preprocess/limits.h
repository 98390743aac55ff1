// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>

#include "cloud_preprocess/describe.h"
#include "scan_cell_common/cloud_files.h"

namespace cloud_preprocess {

/// Limits given by hand, in the cloud's frame: points outside are removed, the limits themselves
/// are inside. Infinite where not given.
struct Limits {
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  double x_min = -kNone;  //!< [m]
  double x_max = kNone;   //!< [m]
  double y_min = -kNone;  //!< [m]
  double y_max = kNone;   //!< [m]
  double z_min = -kNone;  //!< [m]
  double z_max = kNone;   //!< [m]

  bool contain(const pcl::PointXYZ& point) const;
};

/// @throw scan_cell_common::InvalidParameter where a least is not below its most
void check_order(const Limits& limits);

template <class Reader>
void describe(Reader& reader, Limits& limits) {
  const typename Reader::Range any{-Limits::kNone, Limits::kNone};
  reader.read("x_min", limits.x_min, any);
  reader.read("x_max", limits.x_max, any);
  reader.read("y_min", limits.y_min, any);
  reader.read("y_max", limits.y_max, any);
  reader.read("z_min", limits.z_min, any);
  reader.read("z_max", limits.z_max, any);
  check_order(limits);
}

/// Removes the points outside. Says how many in words; empty where there was none.
/// @throw scan_cell_common::UnusableInput if none is left
std::string cut(scan_cell_common::Cloud& cloud, const Limits& limits);

}  // namespace cloud_preprocess
