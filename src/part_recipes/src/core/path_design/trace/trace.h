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
  bool corner = false;                                 //!< of the way: a waypoint stands here
};

/// A way over a surface. Where it goes over a sharp edge two corners stand in the same place, each
/// with the normal of its side.
struct Trace {
  std::vector<TracePoint> points;  //!< straight in between
  bool closed = false;             //!< from the last point it goes on to the first
};

/// [m] with the way from the last to the first of a closed one
double length_of(const Trace& trace);

/// A place between two points of a trace.
/// @param share 0: at the first; 1: at the other
TracePoint between(const TracePoint& from, const TracePoint& to, double share);

/// The parts of an open trace where something holds, their ends found by halving to 1e-8 m.
/// @param step [m] in which it is looked at
std::vector<Trace> kept_where(const Trace& trace, double step,
                              const std::function<bool(const TracePoint&)>& holds);

/// An open trace that ends where it begins, from a closed one: at its first corner, if it has one.
/// Open ones are returned as they are.
Trace opened(const Trace& trace);

/// The same way back.
Trace reversed(Trace trace);

}  // namespace part_recipes::path_design
