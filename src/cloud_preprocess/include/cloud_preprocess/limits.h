// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>

#include "cloud_preprocess/traced_cloud.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace cloud_preprocess {

/// Limits given by hand, in the cloud's frame. Points outside are removed; points on a limit are
/// inside. Infinite if not given.
struct Limits {
  static constexpr double kNone = std::numeric_limits<double>::infinity();  //!< no limit

  double x_min = -kNone;  //!< [m]
  double x_max = kNone;   //!< [m]
  double y_min = -kNone;  //!< [m]
  double y_max = kNone;   //!< [m]
  double z_min = -kNone;  //!< [m]
  double z_max = kNone;   //!< [m]

  bool contain(const pcl::PointXYZ& point) const;  //!< whether the point is within all limits
};

/// Describes every limit: unit and meaning. Refuses a minimum that is not below its maximum.
void describe(scan_cell_common::ParameterTable& table, Limits& limits);

/// Removes the points outside. Returns a text with their number; empty if there are none.
/// @throw scan_cell_common::UnusableInput if no point is left
std::string cut(TracedCloud& cloud, const Limits& limits);

}  // namespace cloud_preprocess
