// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tool_path_stretcher/residuals.h"
#include "tool_path_stretcher/tool_path.h"

namespace tool_path_stretcher {

/// How well one adapted waypoint is founded on the scan. NaN: not known.
struct WaypointQuality {
  std::size_t segment = 0;
  std::size_t waypoint = 0;     //!< within its segment
  bool measured = false;        //!< set on scanned points; false: inferred
  double distance_to_scan = 0;  //!< [m] from the adapted waypoint to the nearest scanned point
  std::size_t support = 0;      //!< scanned points within the support radius
  double residual = 0;       //!< [m] RMS distance of those points from the surface fitted to them
  double displacement = 0;   //!< [m] from where the similarity alone would put the waypoint
  double surface_angle = 0;  //!< [rad] between the normal carried over and the scanned one
  double gap = 0;   //!< [m] surface beside the waypoint to the scanned one, along the normal
  double hole = 0;  //!< [m] from the surface beside the waypoint to the nearest scanned point
};

struct PlacementParameters {
  double support_radius =
      0;                //!< [m] of the scanned points a waypoint is set on; 0: from the spacing
  int min_support = 6;  //!< fewer scanned points, and the waypoint is inferred
  bool set_on_surface = true;  //!< false: carried over by the mapping alone (the affine method)
};

struct Placement {
  ToolPath path;
  std::vector<WaypointQuality> quality;  //!< one a waypoint, in the path's order
};

/// Carries a path over to the object. Each waypoint is moved by the mapping; then by the distance
/// of the scanned surface from the mapped one, along the normal, as far as that distance stands out
/// from the noise. Its rotation follows the mapping's turn and the tilt of the surface. Where the
/// surface was not scanned the correction is inferred from the neighbours along the path.
Placement place(const ToolPath& path, const Surface& reference, const Surface& object,
                const Mapping& mapping, const PlacementParameters& parameters);

}  // namespace tool_path_stretcher
