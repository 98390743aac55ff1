// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "placement/track.h"

namespace tool_path_stretcher {

/// How much heights and slopes vary along the whole path beyond what the noise explains.
struct Signal {
  double height_variance = 0;  //!< [m^2]
  double slope_variance = 0;   //!< of each component
};

constexpr double kMedianOfOne = 0.455;  //!< of a chi-square with one degree of freedom
constexpr double kMedianOfTwo = 1.386;  //!< with two

/// Variance of what waypoints measured beyond their errors: robust, so that few beside edges or in
/// a dent do not stand for all.
/// @param squares of what each measured
/// @param median_of_one of the squares, where each component has the variance 1
/// @param errors as many variances of the measurements are taken off
double variance_beyond(const std::vector<double>& squares, const std::vector<double>& variances,
                       double median_of_one, double errors);

Signal signal_of(const std::vector<Track>& tracks);

/// [m, object] that each waypoint of a segment is moved by along the normal, over the mapping: the
/// measured heights, smoothed along the path and followed as far as they stand out from their
/// errors; between the measured waypoints inferred. In the air nothing.
/// @param width [m, object] of the smoothing, one standard deviation
std::vector<double> heights_along(const Track& track, double width, const Signal& signal);

/// How the surface beside a waypoint is tilted over the mapped one.
struct Tilt {
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();  //!< in the reference's frame, as followed
  double variance = 0;                              //!< of each component of the error that is left
};

/// Of each waypoint of a segment: the slopes of one face, never of two across an edge, smoothed
/// along the path. Followed as far as they are measured and more than the errors of mapping and
/// noise; a slope that only one waypoint shows is not. Nothing where nothing was measured.
/// @param width [m, object] of the smoothing, one standard deviation
/// @param follow false: only what error that leaves
std::vector<Tilt> tilts_along(const Track& track, double width, const Signal& signal, bool follow);

}  // namespace tool_path_stretcher
