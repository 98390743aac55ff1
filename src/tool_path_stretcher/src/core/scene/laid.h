// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "geometry/kd_tree.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// Points of a scan that belong together, by their indices.
using Piece = std::vector<std::size_t>;

/// Spacings between neighbours of one thing; chosen.
constexpr double kGap = 2.5;

/// Where a reference came to lie, by points of it.
class Laid {
 public:
  /// @param more of it, as dense as they may be
  Laid(const Points& reference, double inlier_distance, const Points& more = {});

  const Points& points() const { return tree_.points(); }

  bool explains(const Eigen::Vector3d& point) const {
    return tree_.nearest(point).squared_distance <= reach_ * reach_;
  }

  /// The share of the object's points chosen that it explains.
  double explains(const Surface& object, const Piece& piece) const;

 private:
  KdTree tree_;
  double reach_;  // [m]
};

/// The points but for the faces that the reference, as it came to lie, does not explain. A face is
/// smooth, and ends where the scan has a gap or an edge.
/// @param least_of_scraps share of its points that must be explained of what is too small to be a
/// face
/// @return in rising order
Piece explained(const Surface& object, const Laid& reference, double least_of_scraps);

/// Whether a reference came to lie on two things, by points of it.
bool lie_apart(const Points& one, const Points& other);

}  // namespace tool_path_stretcher
