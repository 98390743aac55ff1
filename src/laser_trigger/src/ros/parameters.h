// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "laser_trigger/pulse_generator.h"

namespace laser_trigger {

struct Parameters {
  PortAddress port = PortAddress::parallel(PortAddress().device);
  PulseGenerator::Settings pulses;
  double hang_timeout = 2;  //!< [s]
};

/// Adds each parameter with its range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, Parameters& parameters);

}  // namespace laser_trigger
