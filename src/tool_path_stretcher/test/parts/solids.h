// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PolygonMesh.h>

#include <Eigen/Core>
#include <vector>

namespace cases {

/// Corners [m] of a closed line in the plane, without crossings.
using Loop = std::vector<Eigen::Vector2d>;

/// A regular polygon about the origin with a corner on the x axis.
Loop regular(int corners, double radius);

/// A regular star about the origin: corners alternate between the two radii, the first at `outer`
/// on the x axis.
Loop star(int points, double outer, double inner);

Loop rectangle_loop(double width, double depth);

/// A circle as a polygon with that many corners.
Loop circle(const Eigen::Vector2d& centre, double radius, int corners = 48);

/// A plus sign: two bars of the given length and width that cross at the origin.
Loop cross(double length, double width);

/// Whether a point of the plane lies inside a loop, and its distance [m] from the line.
bool is_inside(const Loop& loop, const Eigen::Vector2d& at);
double distance_to(const Loop& loop, const Eigen::Vector2d& at);

/// A flat solid as cut from a plate.
struct Solid {
  Loop outline;
  std::vector<Loop> holes;  //!< through it
  double height = 0;        //!< [m] from z = 0
  double taper = 1;         //!< size of the top relative to the bottom
};

/// Its whole surface as triangles with outward normals.
/// @throw std::logic_error if a loop crosses itself or another one
pcl::PolygonMesh mesh_of(const Solid& solid);

}  // namespace cases
