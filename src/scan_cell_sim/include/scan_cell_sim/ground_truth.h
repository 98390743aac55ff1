// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scan_cell_sim/scene.h"

namespace scan_cell_sim {

/// Distances of points from the true surfaces.
struct CloudError {
  std::size_t points = 0;  //!< compared
  double rms = 0;          //!< [m]
  double mean = 0;         //!< [m]
  double max = 0;          //!< [m]
};

/// @throw scan_cell_common::UnusableInput if there is no point, a point is not finite, or there is
/// no surface
CloudError compare(const Scene& truth, const std::vector<Eigen::Vector3d>& points);

/// Points evenly spread over the surfaces visible from straight above, each moved along the
/// surface's normal by Gaussian noise. The same seed gives the same points.
/// @param noise [m] standard deviation, not below 0
/// @throw scan_cell_common::InvalidParameter if the count is 0 or the noise is negative
std::vector<Eigen::Vector3d> sample(const Scene& scene, std::size_t count, std::uint64_t seed,
                                    double noise);

}  // namespace scan_cell_sim
