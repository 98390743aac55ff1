// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool_path_stretcher/placement.h"
#include "tool_path_stretcher/residuals.h"
#include "tool_path_stretcher/stretch_parameters.h"
#include "tool_path_stretcher/tool_path.h"
#include "tool_path_stretcher/verdict.h"

namespace tool_path_stretcher {

// Every reason to refuse, one function each. All throw Refusal.

/// UNUSABLE_INPUT, TOO_FEW_POINTS
void check_surfaces(const Surface& reference, const Surface& object,
                    const StretchParameters& parameters);

/// UNUSABLE_INPUT, PATH_OFF_REFERENCE
void check_path(const ToolPath& path, const Surface& reference,
                const StretchParameters& parameters);

[[noreturn]] void refuse_wrong_part(const std::string& why);

/// @param mirrored how well the reference's mirror image explains the object
[[noreturn]] void refuse_mirrored(const Explanation& mirrored, const Explanation& explanation);

[[noreturn]] void refuse_search_at_bound(double scale, const StretchParameters& parameters);

/// WRONG_PART: too little of the object lies on the reference
void check_explained(const Explanation& explanation, const StretchParameters& parameters);

/// WRONG_PART, SCALE_AT_BOUND
void check_overlap(const Explanation& explanation, const Similarity& similarity,
                   const StretchParameters& parameters);

/// WRONG_PART: the deformation is larger than allowed over the surface
void check_deformation(const Surface& reference, const Mapping& mapping,
                       const StretchParameters& parameters);

bool is_same_pose(const Similarity& one, const Similarity& other, const Surface& reference);

[[noreturn]] void refuse_ambiguous(const ToolPath& path, const Mapping& best, const Mapping& other);

/// AMBIGUOUS: the other explains the object as well and puts the path elsewhere. Where an initial
/// pose is known, poses that lead into each other, as along a straight moulding, count as one: how
/// far apart they lie is in the expected errors.
void check_unambiguous(const ToolPath& path, const Mapping& best, const Mapping& other,
                       const Surface& reference, const Surface& object,
                       const Explanation& best_explanation, const Explanation& other_explanation,
                       const StretchParameters& parameters);

/// FOLD_OVER: the mapping turns the surface over, or the adapted path runs back where the path runs
/// on
/// @param adapted the path as it was placed
void check_fold_over(const ToolPath& path, const ToolPath& adapted, const Surface& reference,
                     const Surface& object, const Mapping& mapping);

/// [m, object] that a scanned point may be off the reference: sparser surfaces cannot show less.
double most_stranger(const StretchParameters& parameters, double spacing);

/// PATH_NOT_SCANNED, TOLERANCE_EXCEEDED, WRONG_PART. Where the surfaces are sparser than the
/// parameters ask for, as much is allowed as they can show.
/// @param spacing [m, object] of the reference's points and of the object's, summed
void check_placement(const std::vector<WaypointQuality>& quality, double spacing,
                     const StretchParameters& parameters);

}  // namespace tool_path_stretcher
