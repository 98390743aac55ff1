// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "deviation/reference/reference_surface.h"
#include "scan_cell_common/geometry/point_tree.h"

namespace tool_path_stretcher {
struct Surface;
}

namespace part_recipes {

/// A piece of a scanned surface around one of its points, as a quadratic height over the tangent
/// plane. The neighbours smooth the scan's noise, and curvature causes no error.
struct SurfacePiece {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  //!< columns; z is the normal
  Eigen::Matrix<double, 6, 1> height = Eigen::Matrix<double, 6, 1>::Zero();  //!< of 1 x y xx xy yy
  bool beside_edge = false;   //!< a sharp edge runs through its neighbours
  bool outside_known = true;  //!< false: no viewer tells its sides apart
};

/// A scanned reference.
class CloudReference final : public ReferenceSurface {
 public:
  explicit CloudReference(const tool_path_stretcher::Surface& surface);

  double signed_distance(const Eigen::Vector3d& point, const Reach& reach) const override;

 private:
  double distance_from(std::size_t piece, const Eigen::Vector3d& point, const Reach& reach) const;

  scan_cell_common::PointTree tree_;  // of samples()
  std::vector<SurfacePiece> pieces_;
};

}  // namespace part_recipes
