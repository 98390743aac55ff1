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

/// [m] diagonal of the box in which evenly spread points would lie as far apart as the surface's:
/// the variances of one are w^2 / 12. Limits that are a share of the part are one of this.
inline double length_of(const Surface& surface) {
  return std::sqrt(12.0) * surface.size;
}

}  // namespace tool_path_stretcher
