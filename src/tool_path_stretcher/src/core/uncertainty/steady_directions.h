// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mapping/graph_equations.h"

namespace tool_path_stretcher {

/// Replaces the directions of constraints along normals by those of a wider neighbourhood, and
/// returns the remaining error of each [rad].
std::vector<double> steady_directions(const Surface& object, const Mapping& mapping,
                                      std::vector<GraphConstraint>& constraints);

/// The same for rims.
std::vector<double> steady_rims(const Surface& object, const Mapping& mapping,
                                std::vector<GraphConstraint>& constraints);

}  // namespace tool_path_stretcher
