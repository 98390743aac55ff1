// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "mapping/residuals.h"
#include "placement/placement.h"
#include "search/candidates.h"
#include "tool_path_stretcher/stretch_parameters.h"

namespace tool_path_stretcher {

bool is_thesis(Method method);  //!< one of the two as the thesis writes them

/// Where the registration of `thesis_affine` or `thesis_general` puts the reference. It starts from
/// the initial pose, where that is known, and tries the scale that is known.
/// @throw Refusal WRONG_PART, SCALE_AT_BOUND
Similarity register_as_thesis(const SurfacePair& surfaces, const StretchParameters& parameters,
                              const AlignmentProgress& progress);

/// AMBIGUOUS: the registration ended in a pose that explains the object clearly worse than one that
/// the suite's own search found elsewhere.
/// @throw Refusal
void check_registration(const SurfacePair& surfaces, const Fitted& registered,
                        const std::vector<Fitted>& searched);

/// 9.7, steps 6 to 8: moves each waypoint to the object's point nearest to it, where the mapping is
/// the registration; what is in the air stays there. The heights are those applied, so that
/// expect_errors() knows of them.
void move_to_nearest_points(const ToolPath& path, const SurfacePair& surfaces,
                            const Mapping& mapping, Placement& placement);

/// Adds what the choice of one of the object's points leaves open along the surface.
/// @param spacing [m] of the object's points
void expect_sampling_errors(double spacing, Placement& placement);

}  // namespace tool_path_stretcher
