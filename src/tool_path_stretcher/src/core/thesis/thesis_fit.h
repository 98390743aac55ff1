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

bool is_thesis(Method method);  //!< one of the thesis' two methods as published

/// The pose that the registration of `thesis_affine` or `thesis_general` finds. It starts from the
/// initial pose and tries the known scale, if they are given.
/// @throw Refusal WRONG_PART, SCALE_AT_BOUND
Similarity register_as_thesis(const SurfacePair& surfaces, const StretchParameters& parameters,
                              const AlignmentProgress& progress);

/// AMBIGUOUS: the registered pose explains the object clearly worse than another pose that the
/// suite's own search found.
/// @throw Refusal
void check_registration(const SurfacePair& surfaces, const Fitted& registered,
                        const std::vector<Fitted>& searched);

/// 9.7, steps 6 to 8: moves each waypoint to the object's nearest point; the mapping is the
/// registration. Waypoints in the air stay where they are. The heights are set to those applied, so
/// that expect_errors() takes them into account.
void move_to_nearest_points(const ToolPath& path, const SurfacePair& surfaces,
                            const Mapping& mapping, Placement& placement);

/// Adds the tangential error of choosing one of the object's points.
/// @param spacing [m] of the object's points
void expect_sampling_errors(double spacing, Placement& placement);

}  // namespace tool_path_stretcher
