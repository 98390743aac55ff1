// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "geometry/kd_tree.h"
#include "mapping/residuals.h"

namespace tool_path_stretcher {

/// A connected piece of scanned surface that is not on the reference: a rib, a clamp, the floor.
struct StrangerPatch {
  double area = 0;                                   //!< [m^2]
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  //!< [m] in the object's frame
};

/// The patches of a scan that the reference does not explain. A few points beside an edge do not
/// count.
class Strangers {
 public:
  /// @param residuals of all of the object's points
  /// @param max_off [m, object] a scanned point farther off the reference is a stranger
  Strangers(const SurfacePair& surfaces, const Mapping& mapping,
            const std::vector<Residual>& residuals, double max_off);

  /// What is over or under a place.
  struct Beside {
    std::size_t points = 0;
    StrangerPatch patch;  //!< the patch that most of them belong to
  };

  /// Strangers within a radius, and up to several times as far over and under it: what stands there
  /// hides the surface itself. If the surface was not seen although it faces the viewers, up to the
  /// part's length over it: of a high rib, a scan may show only the top. Strangers under the
  /// surface do not count if the reference is a scan, which may not have shown them.
  /// @param at [m, object]
  /// @param normal unit length, of the surface there
  /// @param is_seen the surface itself was scanned there, so nothing stands on it
  Beside beside(const Eigen::Vector3d& at, const Eigen::Vector3d& normal, double radius,
                bool is_seen) const;

 private:
  /// Indices of these points in the tree.
  std::vector<std::size_t> column(const Eigen::Vector3d& at, const Eigen::Vector3d& normal,
                                  double radius, bool is_seen) const;

  std::vector<StrangerPatch> patches_;
  std::vector<std::size_t> patch_of_;     // of each point in the tree
  std::unique_ptr<const KdTree> points_;  // null: there are no strangers
  Eigen::AlignedBox3d box_;               // bounding box of the points
  Points viewers_;                        // unit length: towards those who saw the object
  bool under_counts_ = false;
  double length_ = 0;  // [m, object] of the reference
};

}  // namespace tool_path_stretcher
