// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "placement/placement.h"
#include "verdict/checks.h"

namespace tool_path_stretcher {

// Reasons to refuse a path that was placed. All throw Refusal.

/// FOLD_OVER: the mapping turns the surface over, or the adapted path runs back where the path runs
/// on
/// @param adapted the path as it was placed
void check_fold_over(const ToolPath& path, const ToolPath& adapted, const SurfacePair& surfaces,
                     const Mapping& mapping);

/// [m, object] that a scanned point may be off the reference: sparser surfaces cannot show less.
double max_stranger(const StretchParameters& parameters, double spacing);

/// What limits are relative to.
struct PlacementLimits {
  double spacing;  //!< [m, object] of the reference's points and of the object's, summed
  double length;   //!< [m, object] of the part, as length_of() has it
  /// Whether edges of the reference are told from where a scan of it ended. Otherwise the expected
  /// error along the surface may be far too large, and refuses nothing.
  bool edges_are_known;
};

/// PATH_NOT_SCANNED, TOLERANCE_EXCEEDED, WRONG_PART, POSITION_UNCERTAIN, ORIENTATION_UNCERTAIN.
/// Where the surfaces are sparser than the parameters ask for, as much is allowed as they can show.
/// Of waypoints in the air nothing is asked.
void check_placement(const Placement& placement, const PlacementLimits& limits,
                     const StretchParameters& parameters);

}  // namespace tool_path_stretcher
