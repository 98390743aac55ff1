// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "cloud_preprocess/floor_removal.h"
#include "geometry/plane_search.h"

namespace cloud_preprocess {

inline std::size_t share_of(const OrientedPoints& sample, double share) {
  return static_cast<std::size_t>(share * static_cast<double>(sample.size()));
}

/// Number of points that a floor must have.
inline std::size_t min_points_of(const OrientedPoints& sample, const FloorParameters& parameters) {
  constexpr std::size_t kMinPoints = 50;  // chosen
  return std::max(kMinPoints, share_of(sample, parameters.min_share));
}

}  // namespace cloud_preprocess
