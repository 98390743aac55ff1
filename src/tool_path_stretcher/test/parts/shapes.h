// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parts/part.h"

namespace cases {

using Height = std::function<double(double x, double y)>;
using Inside = std::function<bool(double x, double y)>;
using Parametric = std::function<Eigen::Vector3d(double u, double v)>;
using Kept = std::function<bool(const Eigen::Vector3d& middle)>;

constexpr double kStep = 1e-6;  // [m] for derivatives

/// The surface of a height field at a place.
SurfacePoint top_at(const Height& height, double x, double y);

/// A waypoint on a surface: z along the normal, x the part of `along` within the surface.
tool_path_stretcher::Waypoint waypoint_at(const SurfacePoint& point, const Eigen::Vector3d& along);

/// The top of a height field over the cells inside an outline, and walls down to z = 0.
std::vector<Facet> facets_of(double width, double depth, const Inside& inside, const Height& height,
                             bool walls);

/// A surface over u and v in 0 .. 1, in columns x rows pieces. d/du x d/dv points out of the part.
/// @param kept selects pieces by their middle; empty: all
std::vector<Facet> patches(const Parametric& at, int columns, int rows, const Kept& kept = {});

/// A flat piece. u_edge x v_edge points out of the part.
Facet rectangle(const Eigen::Vector3d& corner, const Eigen::Vector3d& u_edge,
                const Eigen::Vector3d& v_edge);

void append(const std::vector<Facet>& more, std::vector<Facet>& facets);

/// A path in one segment, even in the parameter; `at` gives the surface beside the path.
ToolPath path_along(const std::function<SurfacePoint(double a)>& at);

/// The point at share `a` around a rectangle with half edges x and y.
Eigen::Vector2d around(double x, double y, double a);

double half_diagonal(double width, double depth);

}  // namespace cases
