// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "alignment/candidate.h"
#include "mapping/residuals.h"
#include "tool_path_stretcher/stretch_result.h"

namespace tool_path_stretcher {

/// One try to adapt a path: with all of the reference, or with what can be seen of it.
struct Attempt {
  bool whole = true;                       //!< all of the reference
  StretchResult result;                    //!< with its verdict
  std::vector<Candidate> candidates = {};  //!< the poses that were found, best first
  std::vector<Fitted> fitted = {};  //!< what explains the object, best first; none: nothing does
};

/// From where a closed reference may have been seen, where the object lies as an attempt with all
/// of it says, by what explains the object or by the poses that fit best while nothing is bent:
/// the directions that the object's points carry, as it lies or turned over; without them the side
/// that its points lie on, and the other one.
std::vector<ViewPrior> possible_views(const SurfacePair& surfaces, const Attempt& whole);

/// The attempt that tells what to do: of those with a part of the reference, the one that explains
/// the object best, unless all of the reference explains clearly more. Where several do as well and
/// are accepted, they must lay the path to the same places, but for what is in the air, or it is
/// AMBIGUOUS.
/// @param attempts with all of the reference first
StretchResult judge(const std::vector<Attempt>& attempts, const ToolPath& path,
                    const SurfacePair& surfaces, const StretchParameters& parameters);

}  // namespace tool_path_stretcher
