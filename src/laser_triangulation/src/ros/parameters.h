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

  /// A cloud with more goes into a file. The default leaves room below the 1e9 bytes above which
  /// roscpp breaks off a connection, for what an action's result holds besides.
  std::size_t most_message_points = 40'000'000;
  std::string cloud_folder = ".";  //!< for these files

  /// @throw scan_cell_common::InvalidParameter
  static Parameters load(const ros::NodeHandle& node);
};

}  // namespace laser_triangulation
