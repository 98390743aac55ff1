// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mapping/residuals.h"

namespace tool_path_stretcher {

/// The share of what can be seen of the reference, as a mapping lays it, that the object covers:
/// seen from where the object was, or, where that is not known, from the side of the two along its
/// mean normal that shows more of what it covers.
/// @param inlier_distance [m]
double seeable_overlap(const SurfacePair& surfaces, const Mapping& mapping, double inlier_distance);

}  // namespace tool_path_stretcher
