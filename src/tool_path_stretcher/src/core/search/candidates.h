// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "search/partial_search.h"

namespace tool_path_stretcher {

/// Receives the progress of the search (0 .. 1); may throw to end it.
using AlignmentProgress = std::function<void(double)>;

/// All distinct poses that may explain the object, best first. The search needs no initial guess:
/// it starts from the principal frames in all their rotations, a sweep about the vertical, and an
/// even cover of all rotations, and runs the rounds of rounds.h. Residuals are measured in the
/// object's frame and in both directions, so shrinking the reference never wins. No candidate
/// contradicts the prior. If the prior gives a pose, the search starts there, and ends there if
/// that pose explains all of the object.
/// @param partial searched only if the other guesses fail; the caller may go on using it
std::vector<Candidate> find_candidates(const SurfacePair& surfaces, const Prior& prior,
                                       PartialSearch& partial, const AlignmentProgress& progress);
std::vector<Candidate> find_candidates(const SurfacePair& surfaces, const Prior& prior,
                                       const AlignmentProgress& progress);

/// The poses found from the principal frames alone, and from the reference rotated within itself.
/// Enough if a reference nearly fits.
/// @param bulk_cost [m] of another reference on the object: poses far worse are left out
std::vector<Candidate> find_near_candidates(const SurfacePair& surfaces, const ScalePrior& scale,
                                            double bulk_cost);

}  // namespace tool_path_stretcher
