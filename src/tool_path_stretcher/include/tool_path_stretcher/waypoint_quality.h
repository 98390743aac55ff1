// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>

namespace tool_path_stretcher {

/// Stands for a figure that is not known.
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// How well one adapted waypoint is founded on the scan. NaN: not known.
struct WaypointQuality {
  std::size_t segment = 0;      //!< index of the waypoint's segment
  std::size_t waypoint = 0;     //!< within its segment
  bool measured = false;        //!< set on scanned points; false: inferred, or in the air
  bool in_air = false;          //!< no surface beside it: carried by the mapping, needs no scan
  double distance_to_scan = 0;  //!< [m] from the adapted waypoint to the nearest scanned point
  std::size_t support = 0;      //!< scanned points within the support radius
  double residual = 0;       //!< [m] RMS distance of those points from the surface fitted to them
  double displacement = 0;   //!< [m] from where the similarity alone would put the waypoint
  double surface_angle = 0;  //!< [rad] between the normal carried over and the scanned one
  double gap = 0;  //!< [m] surface beside the waypoint to the scanned one, along the normal
  std::size_t strangers = 0;  //!< scanned points beside the waypoint, far off the reference
  double hole = 0;  //!< [m] from the surface beside the waypoint to the nearest scanned point

  // One standard deviation each
  double expected_error_normal = kUnknown;       //!< [m] along the surface's normal
  double expected_error_tangential = kUnknown;   //!< [m] within the surface, in all
  double expected_error_across = kUnknown;       //!< [m] within it, at right angles to least_known
  double expected_error_orientation = kUnknown;  //!< [rad] of all three axes; no orientation: NaN
  Eigen::Vector3d least_known =
      Eigen::Vector3d::Zero();     //!< unit length: the way along the surface known least, object
  bool position_measured = false;  //!< the scan shows the position along the surface; false:
                                   //!< it follows from how stiff the part is taken to be
};

}  // namespace tool_path_stretcher
