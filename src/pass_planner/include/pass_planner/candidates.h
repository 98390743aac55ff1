// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pass_planner/sight.h"
#include "scan_cell/scan_request.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace pass_planner {

/// Parameters of plan_passes(). docs/pass_planner.md describes them.
struct PlanParameters {
  int max_passes = 20;       //!< largest number of passes to propose
  double good_angle = 1.05;  //!< [rad] of light and sight to the normal, of a planned pass
  double margin = 0.02;      //!< [m] by which a pass goes beyond the outermost waypoints
  double clearance = 0.1;    //!< [m] of flange, camera and lasers from part and floor
  double floor_height = 0;   //!< [m] z of the floor in world
  double stand_off = 0;      //!< [m] of the camera; 0: where the light crosses its axis
  double speed = 0.06;       //!< [m/s] of the passes
  double rate = 100;         //!< [Hz] frames per second of each laser
};

/// Describes each parameter: range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, PlanParameters& parameters);

/// Passes over these places from many sides: lines, arcs over the part, and arcs around it. Each is
/// just long enough for all lasers to pass over all of the places. The lasers of the passes are not
/// chosen yet.
/// @param places at least one
/// @param image region of the sensor that is read out
std::vector<scan_cell::ScanPass> candidate_passes(const std::vector<Surface::Place>& places,
                                                  const scan_cell_common::ScannerModel& scanner,
                                                  const SightParameters& image,
                                                  const PlanParameters& parameters);

}  // namespace pass_planner
