// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "path_design/surface/part_mesh.h"
#include "tool_path_stretcher/surface.h"

/// Parts in closed form [m].
namespace shapes {

using part_recipes::path_design::PartMesh;
using part_recipes::path_design::Points;
using part_recipes::path_design::Triangle;

constexpr double kDegree = 0.017453292519943295;

struct Soup {
  Points vertices;
  std::vector<Triangle> triangles;

  void add(const Soup& other);
};

/// A rectangle about the origin in z = 0, with a round hole (a polygon of 720 sides) unless its
/// radius is 0. Its normals are +z.
Soup plate(double width, double depth, double hole = 0,
           const Eigen::Vector2d& centre = Eigen::Vector2d::Zero());

/// A grid over u and v, from a function to space; counterclockwise about du x dv.
Soup grid(int columns, int rows, const std::function<Eigen::Vector3d(double u, double v)>& at);

/// Part of a cylinder about the y axis, y from 0 to length, from -angle to angle about +z, outside.
Soup cylinder(double radius, double length, double angle, int facets);

/// A sphere about the origin.
Soup sphere(double radius, int facets);

/// A closed box of twelve triangles, about the origin in x and y, from z = 0 up.
Soup box(double width, double depth, double height);

/// Two planes that meet in a ridge along y, each at 45 degrees; z = -|x|.
Soup roof(double width, double length);

/// Squares in z = 0, side by side where a row of the picture has an x. The last row has the lowest
/// y.
Soup squares(const std::vector<std::string>& picture, double side);

/// A doubly curved panel of 300 x 200 mm without symmetry, with a hole.
Soup panel(int columns);

Soup moved(Soup soup, const Eigen::Isometry3d& motion);

PartMesh mesh_of(const Soup& soup, const Eigen::Vector3d& towards = Eigen::Vector3d::UnitZ());

/// Points spread at random over the triangles, `noise` [m] off along the normal.
Points cloud_of(const Soup& soup, double spacing, double noise, unsigned seed = 1);

PartMesh sheet_of(const Points& cloud, const Eigen::Vector3d& towards = Eigen::Vector3d::UnitZ());

/// ASCII STL, all digits.
void save_stl(const std::string& file, const Soup& soup);

}  // namespace shapes
