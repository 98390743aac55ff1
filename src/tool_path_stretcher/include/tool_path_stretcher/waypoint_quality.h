// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>

namespace tool_path_stretcher {

/// An unknown figure.
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// How well the scan supports one adapted waypoint. NaN: unknown.
struct WaypointQuality {
  std::size_t segment = 0;      //!< index of the waypoint's segment
  std::size_t waypoint = 0;     //!< within its segment
  bool measured = false;        //!< set on scanned points; false: inferred, or in the air
  bool in_air = false;          //!< no surface beside it: moved by the mapping alone, needs no scan
  double distance_to_scan = 0;  //!< [m] from the adapted waypoint to the nearest scanned point
  std::size_t support = 0;      //!< scanned points within the support radius
  double residual = 0;        //!< [m] RMS distance of these points from the surface fitted to them
  double displacement = 0;    //!< [m] from where the similarity alone would put the waypoint
  double surface_angle = 0;   //!< [rad] between the mapped normal and the scanned one
  double gap = 0;             //!< [m] from the mapped surface to the scanned one, along the normal
  std::size_t strangers = 0;  //!< scanned points beside the waypoint that are far off the reference
  double hole = 0;  //!< [m] from the surface beside the waypoint to the nearest scanned point

  // One standard deviation each
  double expected_error_normal = kUnknown;      //!< [m] along the surface's normal
  double expected_error_tangential = kUnknown;  //!< [m] within the surface, in all
  double expected_error_across = kUnknown;      //!< [m] part of that at right angles to least_known
  double expected_error_orientation = kUnknown;  //!< [rad] of all three axes; NaN: no orientations
  Eigen::Vector3d least_known =
      Eigen::Vector3d::Zero();  //!< unit length, object's frame: tangential direction known least
  bool position_measured = false;  //!< the scan shows the position along the surface; false:
                                   //!< inferred from the assumed stiffness
};

}  // namespace tool_path_stretcher
