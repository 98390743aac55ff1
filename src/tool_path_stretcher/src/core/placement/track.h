// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "local_surface/local_surface.h"
#include "tool_path_stretcher/tool_path.h"
#include "uncertainty/mapping_error.h"

namespace tool_path_stretcher {

/// A waypoint, the surface beside it, and both as mapped.
struct Station {
  bool in_air;
  LocalSurface surface;
  Eigen::Vector3d normal;           //!< of the surface; in the air: the tool's axis, if known
  Eigen::Matrix3d turn;             //!< rotation at the waypoint, from the reference to the object
  Eigen::Matrix3d turn_covariance;  //!< [rad^2, object] of `turn`
  MappingError::Covariance covariance;  //!< of the mapped position of the waypoint

  /// Variance of each component of the tilt.
  double tilt_variance() const;
};

/// The waypoints of a segment.
struct Track {
  std::vector<Station> stations;
  std::vector<double> arc_length;  //!< [m, object] to each waypoint
};

/// What the placement is based on.
struct Ground {
  const Mapping& mapping;
  const MappingError& mapping_error;
  const LocalSurfaceFitter& fitter;
};

/// @param in_air of each waypoint: the scan tells nothing there
/// @param has_orientation whether the path has orientations
Track survey(const Segment& segment, const std::vector<bool>& in_air, bool has_orientation,
             const Ground& ground);

/// Waypoints begin, begin + step .. end - 1 of a segment.
struct Stretch {
  std::size_t begin;
  std::size_t end;
  std::size_t step;
};

/// The waypoints within `reach` [m] along the path; not all of them if they are far denser than any
/// scan.
Stretch around(const Track& track, std::size_t at, double reach);

/// The measured waypoints before and after a waypoint. An index equal to the number of waypoints
/// means none.
struct Neighbours {
  std::size_t before;
  std::size_t after;
};
std::vector<Neighbours> measured_neighbours(const Track& track);

/// Interpolates between two measured neighbours by arc length. Beyond the last measured waypoint,
/// returns its value.
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

/// Share of a measurement that is followed: 1 if the signal is far above its variance, 0 if it is
/// noise (Wiener 1949).
double followed(double signal, double variance);

}  // namespace tool_path_stretcher
