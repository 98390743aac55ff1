// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "local_surface/strangers.h"
#include "tool_path_stretcher/tool_path.h"
#include "tool_path_stretcher/waypoint_quality.h"
#include "uncertainty/mapping_error.h"

namespace tool_path_stretcher {

/// How a waypoint was set on the scanned surface, along its normal.
struct PlacedHeight {
  Eigen::Vector3d base;    //!< [m, reference] place of the surface beside it
  Eigen::Vector3d normal;  //!< of the surface, in the object's frame; in the air the tool's axis
  bool measured = false;   //!< otherwise inferred
  double seen = 0;         //!< [m] of the scan over the mapped reference
  double variance = 0;     //!< [m^2] of that
  double applied = 0;      //!< [m] as far as it was followed
  Eigen::Vector3d slope =
      Eigen::Vector3d::Zero();  //!< of the height along the surface, as far as it was followed
  double tilt_variance = 0;     //!< [rad^2] of each component of the tilt that is left
  double signal_variance = 0;   //!< [m^2] of such heights along the path, beyond the noise
  double slope_variance = 0;    //!< of their slopes
  double hole = 0;              //!< [m] to the nearest scanned point
  MappingError::Covariance covariance;  //!< of where the mapping puts the waypoint
  Eigen::Matrix3d turn_covariance;      //!< [rad^2] of how it turns that
};

struct PlacementParameters {
  double support_radius =
      0;                //!< [m] of the scanned points a waypoint is set on; 0: from the spacing
  int min_support = 6;  //!< fewer scanned points, and the waypoint is inferred
  double max_stranger = 0.004;  //!< [m] farther off the reference, a scanned point is a stranger
  std::vector<bool> in_air;     //!< of each waypoint, over all segments
  bool set_on_surface = true;   //!< false: carried over by the mapping alone (the affine method)
  bool keep_stand_off = true;   //!< as long as it is; false: scaled with the part
};

struct Placement {
  ToolPath path;
  std::vector<WaypointQuality> quality;  //!< one a waypoint, in the path's order
  std::vector<PlacedHeight> heights;     //!< the same
  std::vector<StrangerPatch> strangers;  //!< the same: beside each waypoint; no area: none
};

/// Carries a path over to the object. Each waypoint is moved by the mapping; then by the distance
/// of the scanned surface from the mapped one, along the normal, as far as that distance stands out
/// from the noise. Its rotation follows the mapping's turn and the tilt of the surface. Where the
/// surface was not scanned the correction is inferred from the neighbours along the path. In the
/// air the mapping alone moves and turns it.
Placement place(const ToolPath& path, const SurfacePair& surfaces, const Mapping& mapping,
                const MappingError& mapping_error, const PlacementParameters& parameters);

}  // namespace tool_path_stretcher
