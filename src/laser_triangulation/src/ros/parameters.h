// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "laser_triangulation/triangulator.h"

namespace laser_triangulation {

struct Parameters {
  std::string scanner;  //!< path of the scanner model
  PeakLimits limits;
  double publish_rate = 50;              //!< [Hz] of the growing cloud
  std::size_t most_points = 50'000'000;  //!< of a scan (24 bytes each)

  /// @throw scan_cell_common::InvalidParameter
  static Parameters load(const ros::NodeHandle& node);
};

}  // namespace laser_triangulation
