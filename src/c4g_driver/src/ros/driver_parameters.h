// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "c4g_driver/client.h"

namespace c4g_driver {

struct DriverParameters {
  ClientOptions client;
  std::string base_frame = "base_link";
  std::string flange_frame = "tool0";
  std::string flange_link = "flange";  //!< link of the URDF, where flange_frame is measured
  double feedback_rate = 20;           //!< [Hz] of the move action
  double status_rate = 10;             //!< [Hz]
  double jog_silence = 0.2;            //!< [s] without a ~jog after which the robot stops
  double max_jog_override = 10;        //!< [%] of the programmed speed

  /// @throw scan_cell_common::InvalidParameter naming the missing, bad or unknown parameter
  static DriverParameters load(const ros::NodeHandle& node);
};

/// Adds each parameter with its range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, DriverParameters& parameters);

}  // namespace c4g_driver
