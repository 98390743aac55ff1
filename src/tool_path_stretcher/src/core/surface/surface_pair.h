// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// The reference and the scanned object. Both must outlive the pair.
struct SurfacePair {
  const Surface& reference;
  const Surface& object;
};

}  // namespace tool_path_stretcher
