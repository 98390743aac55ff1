// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "tool_path_stretcher/prior.h"
#include "tool_path_stretcher/similarity.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// A pose and size of the reference that is a local optimum, and how well it explains the object.
struct Candidate {
  Similarity similarity;
  double cost = 0;       //!< [m] residual of both directions in the object's frame
  double bulk_cost = 0;  //!< [m] the same without more of the object: floor and loose points
};

/// Says how far the search is (0 .. 1); may throw to end it.
using AlignmentProgress = std::function<void(double)>;

/// All distinct poses that may explain the object, best first, found without an initial guess: from
/// the principal frames in all their turns, a sweep about the vertical, and an even cover of all
/// rotations, refined in stages of which each keeps the better ones. Residuals are measured in the
/// object's frame and in both directions, so that shrinking the reference never wins. None is among
/// them that contradicts the prior; where that holds a pose, the search starts there and ends where
/// it finds all of the object explained.
std::vector<Candidate> find_candidates(const Surface& reference, const Surface& object,
                                       const Prior& prior, const AlignmentProgress& progress);

/// The same, with a search over partial surfaces that may go on to be used.
class PartialSearch;
std::vector<Candidate> find_candidates(const Surface& reference, const Surface& object,
                                       const Prior& prior, PartialSearch& partial,
                                       const AlignmentProgress& progress);

/// The poses that are found from the principal frames alone, and those turned in themselves: enough
/// where a reference nearly fits.
std::vector<Candidate> find_near_candidates(const Surface& reference, const Surface& object,
                                            const ScalePrior& scale);

/// Refines a pose by robust point-to-plane ICP in both directions (Chen and Medioni 1992; Tukey's
/// biweight), with the rims held on each other. The scale of the start must lie in the prior's
/// range.
Similarity refine(const Surface& reference, const Surface& object, Similarity start,
                  const ScalePrior& scale, Density density, int iterations);

/// The pose with the reference moved by about `step` [m] in the two ways, each to both sides, that
/// the surfaces resist least.
std::vector<Similarity> slides(const Surface& reference, const Surface& object,
                               const Similarity& similarity, double step);

/// A line in the object's space [m], its direction of unit length.
struct Axis {
  Eigen::Vector3d at;
  Eigen::Vector3d along;
};

/// The axes, two at most, about which the surfaces resist a turn of the reference least.
std::vector<Axis> freest_axes(const Surface& reference, const Surface& object,
                              const Similarity& similarity);

/// Initial scale of the thesis (9.3): the ratio of the deviations along the principal axes, of
/// points spread evenly.
double principal_scale(const Surface& reference, const Surface& object);

/// The thesis' search (9.5), corrected: scales s (1 + range i / steps), i = -steps .. steps, each
/// with a rigid registration from `start`; most inliers of both directions wins; then once more
/// between the neighbours of the winner.
struct ScaleSearch {
  Similarity best;
  bool at_bound = false;  //!< the winner was an end of the range
};
ScaleSearch search_scale(const Surface& reference, const Surface& object, const Similarity& start,
                         double scale, double range, int steps, double inlier_distance,
                         const AlignmentProgress& progress);

}  // namespace tool_path_stretcher
