// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "geometry/kd_tree.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// Indices of scan points that belong together.
using Piece = std::vector<std::size_t>;

/// Greatest distance between neighbours of one thing, in spacings; chosen.
constexpr double kGap = 2.5;

/// A reference in its found pose, given by points.
class Laid {
 public:
  /// @param further points of it, of any density
  Laid(const Points& reference, double inlier_distance, const Points& more = {});

  const Points& points() const { return tree_.points(); }

  bool explains(const Eigen::Vector3d& point) const {
    return tree_.nearest(point).squared_distance <= reach_ * reach_;
  }

  /// The share of the given object points that it explains.
  double explains(const Surface& object, const Piece& piece) const;

 private:
  KdTree tree_;
  double reach_;  // [m]
};

/// The points without the faces that the laid reference does not explain. A face is smooth and ends
/// at a gap or an edge of the scan.
/// @param least_of_scraps least explained share of the points of a piece too small to be a face
/// @return indices, ascending
Piece explained(const Surface& object, const Laid& reference, double least_of_scraps);

/// Whether two poses of a reference, given by points, lie on two different things.
bool lie_apart(const Points& one, const Points& other);

}  // namespace tool_path_stretcher
