// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace tool_path_stretcher {

/// Groups a part's rims by the direction they face, one of six along the axes. Each group has its
/// own deviation. Otherwise a part's long edges would make outliers of its short ends, which alone
/// show the position along those edges.
/// @param way_of returns the direction in which a rim faces
template <class Each, class WayOf>
std::array<std::vector<Each>, 6> by_facing(const std::vector<Each>& rims,
                                           const Eigen::Matrix3d& axes, const WayOf& way_of) {
  std::array<std::vector<Each>, 6> groups;
  for (const Each& rim : rims) {
    const Eigen::Vector3d way = axes.transpose() * way_of(rim);
    Eigen::Index axis = 0;
    way.cwiseAbs().maxCoeff(&axis);
    groups[static_cast<std::size_t>(2 * axis + (way[axis] > 0 ? 1 : 0))].push_back(rim);
  }
  return groups;
}

}  // namespace tool_path_stretcher
