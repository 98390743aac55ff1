// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "geometry/kd_tree.h"
#include "local_surface/strangers.h"
#include "mapping/residuals.h"

namespace tool_path_stretcher {

/// The scanned surface around one place of the reference, as a height over the mapped reference.
/// Curvature and edges that both surfaces share cancel out.
struct LocalSurface {
  Eigen::Vector3d base;    //!< [m] place on the reference
  Eigen::Vector3d normal;  //!< of the reference there
  bool measured = false;
  double height = 0;           //!< [m, object] of the scan over the reference
  double height_variance = 0;  //!< [m^2]
  Eigen::Vector3d slope =
      Eigen::Vector3d::Zero();  //!< gradient of the height along the reference, in its frame
  double slope_variance = 0;    //!< of each component, including the effect of a tangential shift
  double residual = 0;          //!< [m] RMS of the scanned points from the fitted surface
  std::size_t support = 0;      //!< scanned points
  Strangers::Beside strangers;  //!< scanned points nearby that are far off the reference
};

/// Fits a linear height over the reference's tangent plane, robustly (Tukey's biweight), to the
/// scanned points of the same face within a radius.
class LocalSurfaceFitter {
 public:
  /// @param radius [m, object]
  /// @param max_stranger [m, object] a scanned point farther off the reference is a stranger
  LocalSurfaceFitter(const SurfacePair& surfaces, const Mapping& mapping, double radius,
                     int min_support, double max_stranger);

  /// The surface beside `point` in the reference's space.
  /// @param shift_covariance [m^2, object] of where the mapping puts the point: on a curved surface
  /// or at an edge, a tangential shift looks like a slope
  LocalSurface fit(const Eigen::Vector3d& point, const Eigen::Matrix3d& shift_covariance) const;

  /// The place of the reference nearest to `point`, which is too far away to be measured on the
  /// scan.
  LocalSurface far_from(const Eigen::Vector3d& point) const;

 private:
  bool lies_on_hidden(const Eigen::Vector3d& point, LocalSurface& local) const;

  struct Height {
    Eigen::Vector2d at;    // [m, object] in the tangent plane, from the base
    double height;         // [m, object]
    double weight;         // falls to zero at the radius, and beside an edge
    double blur;           // [m, object] of both surfaces there
    Eigen::Vector2d rise;  // of the height with a shift of the scan along the tangent plane
  };

  std::vector<Height> heights_of(const std::vector<KdTree::Neighbour>& neighbours,
                                 const LocalSurface& local, const Eigen::Vector3d& tangent,
                                 const Eigen::Vector3d& bitangent) const;

  /// Sampling and grid leave the surface beside an edge uncertain.
  void weigh_down_edges(std::vector<Height>& heights) const;

  const Surface& reference_;
  const Surface& object_;
  const Mapping& mapping_;
  double radius_;
  std::size_t min_support_;
  std::vector<Residual> residuals_;  // of all the object's points
  double noise_;                     // [m, object] robust deviation of all of them
  Strangers strangers_;
};

}  // namespace tool_path_stretcher
