// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include "laser_trigger/pulse_generator.h"

namespace laser_trigger {

struct Parameters {
  PortAddress port;
  PulseGenerator::Settings pulses;
  double hang_timeout = 2;  //!< [s] without a sign of life after which the guardian ends the node

  /// @throw scan_cell_common::InvalidParameter
  static Parameters load(const ros::NodeHandle& node);
};

}  // namespace laser_trigger
