// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "alignment/refinement/motion_equations.h"
#include "surface/surface_pair.h"

namespace tool_path_stretcher {

/// The two rigid motions of a pose, about `centre`, that the object's points resist least. They
/// move a point of the object by at most about one metre.
std::array<Vector7d, 2> weakest_motions(const SurfacePair& surfaces, const Similarity& similarity,
                                        const Eigen::Vector3d& centre);

}  // namespace tool_path_stretcher
