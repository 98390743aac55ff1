// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "path_design/surface/mesh_search.h"
#include "path_design/trace/trace.h"
#include "scan_cell_common/geometry/point_tree.h"

namespace part_recipes::path_design {

/// Distance of places on a surface from its borders.
class BorderDistance {
 public:
  /// @param surface must outlive it
  /// @param borders closed
  BorderDistance(const MeshSearch& surface, const std::vector<Trace>& borders);

  /// The place on the borders that is nearest in a straight line [m].
  /// @pre there is a border
  Eigen::Vector3d nearest(const Eigen::Vector3d& point) const;

  /// Whether a place is at least this far [m] from all borders, along the surface.
  bool is_beyond(const Eigen::Vector3d& point, double distance) const;

  bool empty() const { return sides_.empty(); }  //!< there is no border

 private:
  struct Side {
    Eigen::Vector3d begin, end;  // [m]
  };

  const MeshSearch& surface_;
  std::vector<Side> sides_;
  std::vector<Eigen::Vector3d> samples_;  // [m] on the sides
  std::vector<std::size_t> side_of_;      // of each sample
  double step_ = 0;                       // [m] of the samples
  std::unique_ptr<scan_cell_common::PointTree> search_;
};

}  // namespace part_recipes::path_design
