// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "search/candidates.h"

namespace tool_path_stretcher {

/// Initial scale of the thesis (9.3): the ratio of the deviations along the principal axes, over
/// evenly spread points.
double principal_scale(const SurfacePair& surfaces);

/// The thesis' search (9.5), corrected: scales s (1 + range i / steps), i = -steps .. steps, each
/// with a rigid registration from `start`; the most inliers in both directions win; then once more
/// between the winner's neighbours.
struct ScaleSearch {
  Similarity best;
  bool at_bound = false;  //!< the winner is an end of the range
};
ScaleSearch search_scale(const SurfacePair& surfaces, const Similarity& start, double scale,
                         double range, int steps, double inlier_distance,
                         const AlignmentProgress& progress);

}  // namespace tool_path_stretcher
