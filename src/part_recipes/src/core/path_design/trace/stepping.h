// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/trace/trace.h"

namespace part_recipes::path_design {

/// How far waypoints may be apart.
struct Steps {
  double chord = 0.0001;  //!< [m] of the straight line between waypoints from the trace
  double longest = 0.01;  //!< [m] along the trace
};

/// Few points of a trace that stand for it: its ends and corners, between them even steps, halved
/// where the line between two would be farther from the trace than the chord error (Douglas and
/// Peucker 1973). Of a closed trace the first place comes again at the end.
Trace stepped(const Trace& trace, const Steps& steps);

}  // namespace part_recipes::path_design
