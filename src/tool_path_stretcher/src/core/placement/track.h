// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "local_surface/local_surface.h"
#include "tool_path_stretcher/tool_path.h"
#include "uncertainty/mapping_error.h"

namespace tool_path_stretcher {

/// A waypoint, the surface beside it, and what the mapping makes of both.
struct Station {
  bool in_air;
  LocalSurface surface;
  Eigen::Vector3d normal;  //!< of the surface; in the air the tool's axis, where that is known
  Eigen::Matrix3d turn;    //!< of that, from the reference to the object
  Eigen::Matrix3d turn_covariance;      //!< [rad^2, object] of that
  MappingError::Covariance covariance;  //!< of where the mapping puts the waypoint

  /// Of each component of the tilt.
  double tilt_variance() const;
};

/// The waypoints of a segment.
struct Track {
  std::vector<Station> stations;
  std::vector<double> arc_length;  //!< [m, object] to each waypoint
};

/// What a path is laid on.
struct Ground {
  const Mapping& mapping;
  const MappingError& mapping_error;
  const LocalSurfaceFitter& fitter;
};

/// @param in_air of each waypoint: nothing is learned of the scan there
/// @param has_orientation of the path
Track survey(const Segment& segment, const std::vector<bool>& in_air, bool has_orientation,
             const Ground& ground);

/// Waypoints begin, begin + step .. end - 1 of a segment.
struct Stretch {
  std::size_t begin;
  std::size_t end;
  std::size_t step;
};

/// Those within `reach` [m] along the path; not all where they are far denser than any scan.
Stretch around(const Track& track, std::size_t at, double reach);

/// Of each waypoint the measured ones before and after it; as many as there are waypoints: none.
struct Neighbours {
  std::size_t before;
  std::size_t after;
};
std::vector<Neighbours> measured_neighbours(const Track& track);

/// Between what two measured neighbours have, by arc length; what the only one has past the last
/// of them.
template <class Value>
Value between(const Track& track, const Neighbours& neighbours, std::size_t at, const Value& none,
              const std::vector<Value>& values) {
  const bool has_before = neighbours.before < values.size();
  const bool has_after = neighbours.after < values.size();
  if (!has_before && !has_after) return none;
  if (!has_before || !has_after) return values[has_before ? neighbours.before : neighbours.after];
  const double start = track.arc_length[neighbours.before];
  const double span = track.arc_length[neighbours.after] - start;
  const double share = span > 0 ? (track.arc_length[at] - start) / span : 0.5;
  return (1 - share) * values[neighbours.before] + share * values[neighbours.after];
}

/// Part of a measurement that is followed: all of it where the signal is far above its variance,
/// nothing where it is noise (Wiener 1949).
double followed(double signal, double variance);

}  // namespace tool_path_stretcher
