// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mapping/residuals.h"

namespace tool_path_stretcher {

/// The share of the visible part of the mapped reference that the object covers. The reference is
/// seen from where the object was seen. If that is unknown, it is seen along the object's mean
/// normal, from the side that shows more of what the object covers.
/// @param inlier_distance [m]
double seeable_overlap(const SurfacePair& surfaces, const Mapping& mapping, double inlier_distance);

}  // namespace tool_path_stretcher
