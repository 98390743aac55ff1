// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "mapping/residuals.h"
#include "tool_path_stretcher/stretch_parameters.h"
#include "tool_path_stretcher/tool_path.h"
#include "tool_path_stretcher/verdict.h"

namespace tool_path_stretcher {

// Every reason to refuse, one function each. All throw Refusal.

[[noreturn]] void refuse(Reason reason, const std::string& thing, const std::string& value,
                         const std::string& cure, std::vector<std::size_t> waypoints = {});

/// UNUSABLE_INPUT, TOO_FEW_POINTS
void check_surfaces(const SurfacePair& surfaces, const StretchParameters& parameters);

/// UNUSABLE_INPUT, PATH_OFF_REFERENCE: most of the path is in the air, or some of it is beyond any
/// robot's reach.
void check_path(const ToolPath& path, const Surface& reference,
                const StretchParameters& parameters);

/// PATH_NOT_SCANNED: waypoints lie off the visible part of the reference. Waypoints in the air need
/// no surface.
void check_seeable(const ToolPath& path, const Surface& seeable,
                   const StretchParameters& parameters);

[[noreturn]] void refuse_wrong_part(const std::string& why);

/// @param mirrored how well the reference's mirror image explains the object
[[noreturn]] void refuse_mirrored(const Explanation& mirrored, const Explanation& explanation);

[[noreturn]] void refuse_search_at_bound(double scale, const StretchParameters& parameters);

/// WRONG_PART: too little of the object lies on the reference
void check_explained(const Explanation& explanation, const StretchParameters& parameters);

/// WRONG_PART, SCALE_AT_BOUND
void check_overlap(const Fitted& best, const StretchParameters& parameters);

/// WRONG_PART: the deformation is larger than allowed over the surface
void check_deformation(const Surface& reference, const Mapping& mapping,
                       const StretchParameters& parameters);

bool is_same_pose(const Similarity& one, const Similarity& other, const Surface& reference);

/// The pose, and where it puts the waypoints.
PoseCandidate candidate_of(const ToolPath& path, const Mapping& mapping);

[[noreturn]] void refuse_ambiguous(const ToolPath& path, const Mapping& best, const Mapping& other);

/// AMBIGUOUS: the other mapping explains the object as well and puts the path elsewhere. If an
/// initial pose is given, poses that blend into each other, as along a straight moulding, count as
/// one: the expected errors include their distance.
/// @return whether the other explains the object as well and lays the path along the same line
bool check_unambiguous(const ToolPath& path, const SurfacePair& surfaces, const Fitted& best,
                       const Fitted& other, const StretchParameters& parameters);

}  // namespace tool_path_stretcher
