// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "scan_cell_sim/shapes.h"

namespace scan_cell_sim {

/// A part in the world, known exactly. Its own coordinates are those of the undeformed shape; a
/// point of its material is moved to pose * (scale * deformation(point)).
struct Part {
  std::string name;                                        //!< in its world
  Shape shape;                                             //!< undeformed
  Deformation deformation;                                 //!< in the shape's coordinates
  double scale = 1;                                        //!< after the deformation
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  //!< in world
  double reflectance = 0.7;                                //!< 0 .. 1, diffuse

  /// Place in world of a point [m] of the undeformed part.
  Eigen::Vector3d to_world(const Eigen::Vector3d& point) const;

  /// Direction in world of the surface normal of the undeformed part at `point`, after deformation.
  Eigen::Vector3d normal_to_world(const Eigen::Vector3d& point,
                                  const Eigen::Vector3d& normal) const;

  /// Point of the undeformed part that is at `world`.
  /// @throw scan_cell_common::UnusableInput if there is none
  Eigen::Vector3d to_part(const Eigen::Vector3d& world) const;

  /// Surface in world, no more than `tolerance` [m] off the true one.
  /// @throw scan_cell_common::UnusableInput if the deformation folds the part
  Mesh mesh(double tolerance) const;
};

/// The true image on `object` of a tool pose on `reference`: at the same point of the same
/// material, with z against the surface normal there and x along the image of the pose's x. The
/// pose's z must be against the reference's surface normal.
/// @throw scan_cell_common::UnusableInput if the point is not on the reference, or the two parts
/// have different shapes
Eigen::Isometry3d true_image(const Part& reference, const Part& object,
                             const Eigen::Isometry3d& pose);

}  // namespace scan_cell_sim
