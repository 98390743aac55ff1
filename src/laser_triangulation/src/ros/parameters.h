// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "laser_triangulation/triangulator.h"

namespace laser_triangulation {

struct Parameters {
  std::string scanner;
  PeakLimits limits;
  double publish_rate = 50;             //!< [Hz]
  std::size_t max_points = 50'000'000;  //!< per scan (36 bytes each)

  /// The default stays below the 1e9 bytes at which roscpp closes a connection, with room for the
  /// rest of an action's result.
  std::size_t max_message_points = 27'000'000;
  std::string cloud_folder = ".";
};

/// Describes every parameter: range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, Parameters& parameters);

}  // namespace laser_triangulation
