// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "placement/track.h"

namespace tool_path_stretcher {

/// The variation of heights and slopes along the whole path, beyond what noise explains.
struct Signal {
  double height_variance = 0;  //!< [m^2]
  double slope_variance = 0;   //!< of each component
};

constexpr double kMedianOfOne = 0.455;  //!< of a chi-square with one degree of freedom
constexpr double kMedianOfTwo = 1.386;  //!< of one with two

/// Variance of the waypoints' measurements beyond their errors. Robust, so that a few waypoints
/// beside edges or in a dent do not decide for all.
/// @param squares of each measurement
/// @param median_of_one of the squares, for components of variance 1
/// @param errors how many variances of each measurement are subtracted
double variance_beyond(const std::vector<double>& squares, const std::vector<double>& variances,
                       double median_of_one, double errors);

Signal signal_of(const std::vector<Track>& tracks);

/// [m, object] shift of each waypoint of a segment along the normal, in addition to the mapping.
/// These are the measured heights, smoothed along the path and followed as far as they stand out
/// from their errors; between measured waypoints they are inferred. Zero in the air.
/// @param width [m, object] of the smoothing, one standard deviation
std::vector<double> heights_along(const Track& track, double width, const Signal& signal);

/// The tilt of the surface beside a waypoint relative to the mapped one.
struct Tilt {
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();  //!< in the reference's frame, as followed
  double variance = 0;                              //!< of each component of the remaining error
};

/// The tilt of each waypoint of a segment: the slopes of one face, never of two faces across an
/// edge, smoothed along the path. They are followed as far as they are measured and exceed the
/// errors of mapping and noise; a slope that only one waypoint shows is not followed. Zero if
/// nothing was measured.
/// @param width [m, object] of the smoothing, one standard deviation
/// @param follow false: only computes the error that remains
std::vector<Tilt> tilts_along(const Track& track, double width, const Signal& signal, bool follow);

}  // namespace tool_path_stretcher
