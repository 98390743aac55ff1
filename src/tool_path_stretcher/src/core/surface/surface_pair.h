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

/// [m] the part's length: the diagonal of the box whose evenly spread points would have the same
/// spread as the surface's. The variances of a box are w^2 / 12. Limits given as a share of the
/// part's length refer to this.
inline double length_of(const Surface& surface) {
  return std::sqrt(12.0) * surface.size;
}

}  // namespace tool_path_stretcher
