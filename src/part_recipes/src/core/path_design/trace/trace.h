// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace part_recipes::path_design {

/// A place on a surface.
struct TracePoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  //!< [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();   //!< unit length, out of the part
  bool corner = false;                                 //!< of the way: a waypoint is put here
};

/// A way over a surface. Where it crosses a sharp edge, two corners are in the same place, each
/// with the normal of its side.
struct Trace {
  std::vector<TracePoint> points;  //!< straight in between
  bool closed = false;             //!< the last point leads on to the first
};

/// [m] including the way from the last point of a closed trace to the first
double length_of(const Trace& trace);

/// A place between two points of a trace.
/// @param share 0: at the first; 1: at the other
TracePoint between(const TracePoint& from, const TracePoint& to, double share);

/// The parts of an open trace where a condition holds, their ends found by halving to 1e-8 m.
/// @param step [m] at which the condition is checked
std::vector<Trace> kept_where(const Trace& trace, double step,
                              const std::function<bool(const TracePoint&)>& holds);

/// An open trace from a closed one, with the same place at both ends: its first corner, if it has
/// one. Open traces are returned unchanged.
Trace opened(const Trace& trace);

/// The same way backwards.
Trace reversed(Trace trace);

}  // namespace part_recipes::path_design
