// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "tool_path_stretcher/stretch_result.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// Stretches onto one surface of a scan.
using StretchOnto = std::function<StretchResult(const Surface& object)>;

/// Clamps, floor or a neighbour may be in the scan: the reference has to explain its own place
/// whole, not the whole scan. The scan is taken apart into pieces with gaps between them; those
/// that the reference does not explain are other things, and it is stretched onto the rest. Where
/// the pose found is of no use, the largest pieces are tried alone first.
/// @param path for the poses of an ambiguous result
/// @param first of the whole scan: refused because the reference explains too little of it
/// @return what was found so, accepted or refused for another reason; ambiguous where the reference
/// fits onto two things; `first` where nothing was
StretchResult stretch_in_own_place(const Surface& object, const ToolPath& path,
                                   const StretchResult& first, const StretchParameters& parameters,
                                   const StretchOnto& onto);

}  // namespace tool_path_stretcher
