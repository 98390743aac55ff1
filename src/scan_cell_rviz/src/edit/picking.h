// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "cloud_preprocess/edited_cloud.h"

namespace scan_cell_rviz {

/// A ray from the viewer under the cursor, in the cloud's frame, a few pixels wide.
struct Ray {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();      //!< [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  //!< of length 1
  double radius = 0;                                     //!< [m] at the origin
  double widening = 0;                                   //!< [m] growth of the radius per metre
};

/// The point that a person sees there: the one within the ray that is nearest to the viewer.
/// @param points of the cloud that are visible
std::optional<Eigen::Vector3d> picked(const cloud_preprocess::Cloud& cloud,
                                      const cloud_preprocess::EditedCloud::Indices& points,
                                      const Ray& ray);

/// The place that a person means: the one within the ray that is nearest to its axis.
std::optional<std::size_t> meant(const std::vector<Eigen::Vector3d>& places, const Ray& ray);

/// The prism behind a polygon drawn on the screen. In a perspective view its sides are parallel,
/// and it is as wide as the polygon at the depth of the place.
/// @param corners at least 3, in order
/// @param place [m] that gives the depth
/// @param depth [m] before and behind the place
/// @throw scan_cell_common::UnusableInput if the ray of a corner does not meet the place's plane
cloud_preprocess::PrismShape prism_behind(const std::vector<Ray>& corners,
                                          const Eigen::Vector3d& place, double depth);

/// The half-space on the viewer's side of the plane through three places.
/// @throw scan_cell_common::UnusableInput if the places lie on a line
cloud_preprocess::HalfSpace side_towards(const std::vector<Eigen::Vector3d>& places,
                                         const Eigen::Vector3d& viewer);

}  // namespace scan_cell_rviz
