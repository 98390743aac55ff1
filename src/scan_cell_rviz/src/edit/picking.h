// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "cloud_preprocess/edited_cloud.h"

namespace scan_cell_rviz {

/// What lies under the cursor: a ray from the viewer into the cloud's frame, as wide as a few
/// pixels.
struct Ray {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();      //!< [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  //!< of length 1
  double radius = 0;                                     //!< [m] at the origin
  double widening = 0;                                   //!< [m] of radius for each metre
};

/// The point that a person sees there: of those within the ray the nearest to the viewer.
/// @param points of the cloud that can be seen
std::optional<Eigen::Vector3d> picked(const cloud_preprocess::Cloud& cloud,
                                      const cloud_preprocess::EditedCloud::Indices& points,
                                      const Ray& ray);

/// Which of some places a person means: of those within the ray the nearest to its middle.
std::optional<std::size_t> meant(const std::vector<Eigen::Vector3d>& places, const Ray& ray);

/// What is behind a polygon drawn on the screen. Where the view has a perspective its sides are
/// those of the polygon at the depth of the place, and parallel.
/// @param corners 3 at least, in their order
/// @param place [m] that gives the depth
/// @param depth [m] before and behind the place
/// @throw scan_cell_common::UnusableInput if a corner is beside the plane for good
cloud_preprocess::PrismShape prism_behind(const std::vector<Ray>& corners,
                                          const Eigen::Vector3d& place, double depth);

/// The side of the plane through three places on which the viewer is.
/// @throw scan_cell_common::UnusableInput if they lie on a line
cloud_preprocess::HalfSpace side_towards(const std::vector<Eigen::Vector3d>& places,
                                         const Eigen::Vector3d& viewer);

}  // namespace scan_cell_rviz
