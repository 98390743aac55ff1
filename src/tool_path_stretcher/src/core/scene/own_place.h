// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "tool_path_stretcher/stretch_result.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// Stretches the path onto one surface of a scan.
using StretchOnto = std::function<StretchResult(const Surface& object)>;

/// Clamps, floor or a neighbour may be in the scan, so the reference has to explain all of its own
/// place, not the whole scan. Takes the scan apart into pieces separated by gaps. Pieces that the
/// reference does not explain are other things; the path is stretched onto the rest. If the pose
/// found is of no use, the largest pieces are tried alone first.
/// @param path for the poses of an ambiguous result
/// @param first result for the whole scan: refused because the reference explains too little of it
/// @return the result found this way, accepted or refused for another reason; ambiguous if the
/// reference fits onto two things; `first` if nothing was found
StretchResult stretch_in_own_place(const Surface& object, const ToolPath& path,
                                   const StretchResult& first, const StretchParameters& parameters,
                                   const StretchOnto& onto);

}  // namespace tool_path_stretcher
