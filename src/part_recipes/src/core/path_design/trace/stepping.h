// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/trace/trace.h"

namespace part_recipes::path_design {

/// Largest distances between waypoints.
struct Steps {
  double chord = 0.0001;  //!< [m] of the straight line between waypoints from the trace
  double longest = 0.01;  //!< [m] along the trace
};

/// Reduces a trace to a few points: its ends and corners, and even steps between them, halved where
/// the line between two would be farther from the trace than the chord error (Douglas and Peucker
/// 1973). For a closed trace, the first place is repeated at the end.
Trace stepped(const Trace& trace, const Steps& steps);

}  // namespace part_recipes::path_design
