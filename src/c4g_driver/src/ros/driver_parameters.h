// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "c4g_driver/client.h"

namespace c4g_driver {

/// Parameters of the node; docs/c4g_driver.md lists them.
struct DriverParameters {
  ClientOptions client;
  std::string base_frame = "base_link";
  std::string flange_frame = "tool0";
  std::string flange_link = "flange";  //!< of the URDF; lies where flange_frame is measured
  double feedback_rate = 20;           //!< [Hz] of the move action
  double status_rate = 10;             //!< [Hz]

  /// @throw scan_cell_common::InvalidParameter naming the parameter that is missing, bad or unknown
  static DriverParameters load(const ros::NodeHandle& node);
};

}  // namespace c4g_driver
