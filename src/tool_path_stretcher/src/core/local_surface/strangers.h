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

/// The patches of a scan that the reference does not explain. A few points beside an edge are none.
class Strangers {
 public:
  /// @param residuals of all of the object's points
  /// @param max_off [m, object] farther off the reference, a scanned point is a stranger
  Strangers(const SurfacePair& surfaces, const Mapping& mapping,
            const std::vector<Residual>& residuals, double max_off);

  /// What stands over or under a place.
  struct Beside {
    std::size_t points = 0;
    StrangerPatch patch;  //!< that most of them belong to
  };

  /// Within a radius, and up to several times as far over and under it: what stands there hides the
  /// surface itself. Where nothing of the surface was seen although it faces those who looked, as
  /// far over it as the part is long: of a high rib a scan may show the top alone. Not under it
  /// where the reference is a scan: that one may not have shown it.
  /// @param at [m, object]
  /// @param normal unit length, of the surface there
  /// @param is_seen the surface itself was scanned there: nothing stands on it
  Beside beside(const Eigen::Vector3d& at, const Eigen::Vector3d& normal, double radius,
                bool is_seen) const;

 private:
  /// Those points of the tree.
  std::vector<std::size_t> column(const Eigen::Vector3d& at, const Eigen::Vector3d& normal,
                                  double radius, bool is_seen) const;

  std::vector<StrangerPatch> patches_;
  std::vector<std::size_t> patch_of_;     // each point of the tree
  std::unique_ptr<const KdTree> points_;  // none: there are none
  Eigen::AlignedBox3d box_;               // around them
  Points viewers_;                        // unit length: towards those who saw the object
  bool under_counts_ = false;
  double length_ = 0;  // [m, object] of the reference
};

}  // namespace tool_path_stretcher
