// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "local_surface/strangers.h"
#include "tool_path_stretcher/tool_path.h"
#include "tool_path_stretcher/waypoint_quality.h"
#include "uncertainty/mapping_error.h"

namespace tool_path_stretcher {

/// How a waypoint was placed along the normal of the scanned surface.
struct PlacedHeight {
  Eigen::Vector3d base;    //!< [m, reference] place on the surface beside it
  Eigen::Vector3d normal;  //!< of the surface, in the object's frame; in the air: the tool's axis
  bool measured = false;   //!< otherwise inferred
  double seen = 0;         //!< [m] height of the scan over the mapped reference
  double variance = 0;     //!< [m^2] of `seen`
  double applied = 0;      //!< [m] the part of it that was followed
  Eigen::Vector3d slope =
      Eigen::Vector3d::Zero();  //!< of the height along the surface, the part that was followed
  double tilt_variance = 0;     //!< [rad^2] of each component of the remaining tilt
  double signal_variance = 0;   //!< [m^2] of the heights along the path, beyond noise
  double slope_variance = 0;    //!< of the slopes along the path, beyond noise
  double hole = 0;              //!< [m] to the nearest scanned point
  MappingError::Covariance covariance;  //!< of the mapped position of the waypoint
  Eigen::Matrix3d turn_covariance;      //!< [rad^2] of the mapping's rotation there
};

struct PlacementParameters {
  double support_radius =
      0;  //!< [m] of the scanned points that a waypoint is set on; 0: from the spacing
  int min_support = 6;          //!< with fewer scanned points, the waypoint is inferred
  double max_stranger = 0.004;  //!< [m] a scanned point farther off the reference is a stranger
  std::vector<bool> in_air;     //!< of each waypoint, over all segments
  bool set_on_surface = true;   //!< false: moved by the mapping alone (the affine method)
  bool keep_stand_off = true;   //!< false: stand-offs scale with the part
};

struct Placement {
  ToolPath path;
  std::vector<WaypointQuality> quality;  //!< one per waypoint, in the path's order
  std::vector<PlacedHeight> heights;     //!< the same
  std::vector<StrangerPatch> strangers;  //!< the same: beside each waypoint; area 0: none
};

/// Transfers a path to the object. The mapping moves each waypoint. The waypoint then moves along
/// the normal by the distance of the scanned surface from the mapped one, as far as that stands out
/// from the noise. Its orientation follows the mapping's rotation and the tilt of the surface.
/// Where the surface was not scanned, the correction is inferred from neighbours along the path. In
/// the air, only the mapping moves and rotates it.
Placement place(const ToolPath& path, const SurfacePair& surfaces, const Mapping& mapping,
                const MappingError& mapping_error, const PlacementParameters& parameters);

}  // namespace tool_path_stretcher
