// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "deviation/reference/reference_surface.h"
#include "tool_path_stretcher/similarity.h"

namespace part_recipes {

using tool_path_stretcher::Points;

/// How far the points of an object are from the reference.
struct Deviations {
  std::vector<double> values;  //!< [m] of each point, in the object's lengths: positive where
                               //!< material was added; NaN where no surface is near
  Reach reach;                 //!< [m] in the object's lengths: what counted as near
};

/// The distance of neighbouring points [m]: the side of the square that each point fills, as the
/// median over up to 2000 points.
/// @throw scan_cell_common::UnusableInput if there are fewer than 20 points
double spacing_of(const Points& points);

/// The distance up to which the reference counts as near, in the object's lengths: ten tolerances
/// along the normal, or three spacings of the object if that is more; one spacing beyond a border.
/// @param tolerance [m] of deviations
/// @param spacing [m] of the object
Reach reach_of(double tolerance, double spacing);

/// Transforms each point of the object into the reference's frame, and measures there.
/// @param similarity reference to object
/// @param object [m]
/// @throw scan_cell_common::UnusableInput if a point is not finite
Deviations measure(const ReferenceSurface& reference,
                   const tool_path_stretcher::Similarity& similarity, const Points& object,
                   double tolerance);

/// For each sample of the reference, whether a point of the object lies near it: within `reach`
/// along the normal, and twice the object's spacing along the surface.
/// @param reach [m] in the object's lengths
std::vector<bool> scanned(const ReferenceSurface::Samples& samples,
                          const tool_path_stretcher::Similarity& similarity, const Points& object,
                          const Reach& reach);

/// Share of the samples without a point nearby; 0 if there are no samples.
double unscanned_share(const std::vector<bool>& scanned);

}  // namespace part_recipes
