// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "placement/placement.h"
#include "verdict/checks.h"

namespace tool_path_stretcher {

// Reasons to refuse a placed path. All throw Refusal.

/// FOLD_OVER: the mapping turns the surface over, or the adapted path runs backwards where the path
/// runs forwards
/// @param adapted the placed path
void check_fold_over(const ToolPath& path, const ToolPath& adapted, const SurfacePair& surfaces,
                     const Mapping& mapping);

/// [m, object] greatest allowed distance of a scanned point from the reference. Sparser surfaces
/// allow more, since they cannot show less.
double max_stranger(const StretchParameters& parameters, double spacing);

/// The quantities that limits are relative to.
struct PlacementLimits {
  double spacing;  //!< [m, object] of the reference's points and of the object's, summed
  double length;   //!< [m, object] of the part, from length_of()
  /// Whether edges of the reference can be told from the end of its scan. If not, the expected
  /// error along the surface may be far too large, and refuses nothing.
  bool edges_are_known;
};

/// PATH_NOT_SCANNED, TOLERANCE_EXCEEDED, WRONG_PART, POSITION_UNCERTAIN, ORIENTATION_UNCERTAIN. If
/// the surfaces are too sparse for the parameters, the limits grow to what the surfaces can show.
/// Waypoints in the air are not checked.
void check_placement(const Placement& placement, const PlacementLimits& limits,
                     const StretchParameters& parameters);

}  // namespace tool_path_stretcher
