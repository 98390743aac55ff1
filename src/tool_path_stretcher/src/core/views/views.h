// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "alignment/candidate.h"
#include "mapping/residuals.h"
#include "tool_path_stretcher/stretch_result.h"

namespace tool_path_stretcher {

/// One attempt to adapt a path: with the whole reference, or with its visible part.
struct Attempt {
  bool whole = true;                       //!< the whole reference
  StretchResult result;                    //!< with its verdict
  std::vector<Candidate> candidates = {};  //!< the poses found, best first
  std::vector<Fitted> fitted = {};         //!< those that explain the object, best first
};

/// The views from which a closed reference may have been seen. The object's pose comes from an
/// attempt with the whole reference: from the mappings that explain it, or from the best undeformed
/// poses. The directions are those that the object's points carry, as it lies or turned over.
/// Without them, both the side that its points lie on and the opposite side are possible.
std::vector<ViewPrior> possible_views(const SurfacePair& surfaces, const Attempt& whole);

/// The deciding attempt: of those with a part of the reference, the one that explains the object
/// best, unless the whole reference explains clearly more. If several explain it as well and are
/// accepted, they must lay the path to the same places, except for waypoints in the air; otherwise
/// the result is AMBIGUOUS.
/// @param attempts the one with the whole reference first
StretchResult judge(const std::vector<Attempt>& attempts, const ToolPath& path,
                    const SurfacePair& surfaces, const StretchParameters& parameters);

}  // namespace tool_path_stretcher
