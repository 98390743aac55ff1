// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "tool_path_stretcher/stretch_result.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// Called as the work goes on, with the stage and the progress of the whole (0 .. 1). Returns false
/// to cancel. Called from one thread at a time, not always the same.
using Progress = std::function<bool(const std::string& stage, double progress)>;

/// Adapts a path on the reference to the object, or refuses with a reason, on all cores that the
/// process may use. The same input gives the same path, bit for bit, on any number of them.
/// @throw scan_cell_common::InvalidParameter if the parameters make no sense; all else is a verdict
StretchResult stretch(const Surface& reference, const Surface& object, const ToolPath& path,
                      const StretchParameters& parameters, const Progress& progress = {});

/// The same without a path: where the reference lies on the object, or why it does not explain it.
/// Poses that explain the object alike are one as far as that goes, as of a part that is its own
/// image; two things in a scan that it fits are not (AMBIGUOUS).
/// @return its path and quality are empty
/// @throw as stretch()
StretchResult lay(const Surface& reference, const Surface& object,
                  const StretchParameters& parameters, const Progress& progress = {});

}  // namespace tool_path_stretcher
