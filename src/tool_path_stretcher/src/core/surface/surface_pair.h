// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// The reference and the scanned object. Both must outlive the pair.
struct SurfacePair {
  const Surface& reference;
  const Surface& object;
};

/// [m] of a surface, from its size: a box's, filled evenly, whose variances are w^2 / 12.
inline double length_of(const Surface& surface) {
  return std::sqrt(12.0) * surface.size;
}

}  // namespace tool_path_stretcher
