// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "tool_path_stretcher/stretch_result.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// Called during the work with the stage and the overall progress (0 .. 1). Returns false to
/// cancel. Called from one thread at a time, but not always the same one.
using Progress = std::function<bool(const std::string& stage, double progress)>;

/// Adapts a path on the reference to the object, or refuses with a reason. Uses all cores that the
/// process may use. The same input gives the same path, bit for bit, on any number of cores.
/// @throw scan_cell_common::InvalidParameter if the parameters make no sense; every other failure
/// is a verdict
StretchResult stretch(const Surface& reference, const Surface& object, const ToolPath& path,
                      const StretchParameters& parameters, const Progress& progress = {});

/// The same without a path: finds where the reference lies on the object, or why it does not
/// explain it. Poses that explain the object equally well count as one, as for a symmetric part.
/// Two things in the scan that the reference fits do not (AMBIGUOUS).
/// @return a result without path and quality
/// @throw as stretch()
StretchResult lay(const Surface& reference, const Surface& object,
                  const StretchParameters& parameters, const Progress& progress = {});

}  // namespace tool_path_stretcher
