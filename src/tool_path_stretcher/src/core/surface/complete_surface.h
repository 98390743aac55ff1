// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// Adds everything derived from the points: tree, size, spacing, rim, samples, and normals if there
/// are none yet.
void complete(Surface& surface);

}  // namespace tool_path_stretcher
