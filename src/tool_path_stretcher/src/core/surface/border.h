// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "geometry/kd_tree.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// Where a surface ends. Nothing is known beyond it: the part may continue there.
class Border {
 public:
  /// @param points of the surface: all, or an even selection
  /// @param spacing [m] of these points
  Border(const Surface& surface, const Points& points, double spacing);

  /// Whether a point lies beyond the border rather than off the surface.
  /// @param nearest index of the nearest of these points
  /// @param distance [m] to that point
  bool is_beyond(const Eigen::Vector3d& point, std::size_t nearest, double distance) const {
    return at_border_[nearest] && is_outward(point, distance);
  }

 private:
  bool is_outward(const Eigen::Vector3d& point, double distance) const;

  double spacing_;
  std::optional<KdTree> rim_;
  Points outward_;               // of the rim
  std::vector<bool> at_border_;  // of the points
};

}  // namespace tool_path_stretcher
