// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parts/shapes.h"

#include <cmath>

namespace cases {
namespace {

using tool_path_stretcher::Waypoint;

constexpr double kCell = 0.001;  // [m]

void add_wall(const Height& height, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
              const Eigen::Vector2d& out, std::vector<Facet>& facets) {
  constexpr double kInward = 1e-7;  // for the height just inside the wall
  const auto at = [=](double u, double v) {
    const Eigen::Vector2d along = from + u * (to - from);
    const Eigen::Vector2d inner = along - kInward * out;
    return SurfacePoint{{along.x(), along.y(), v * height(inner.x(), inner.y())},
                        {out.x(), out.y(), 0}};
  };
  facets.push_back({(to - from).norm() * at(0.5, 1).position.z(), at});
}

}  // namespace

Waypoint waypoint_at(const SurfacePoint& point, const Eigen::Vector3d& along) {
  Waypoint waypoint;
  Eigen::Matrix3d frame;
  frame.col(2) = point.normal;
  frame.col(1) = point.normal.cross(along).normalized();
  frame.col(0) = frame.col(1).cross(point.normal);
  waypoint.pose.linear() = frame;
  waypoint.pose.translation() = point.position;
  waypoint.process_values = {0.05};
  return waypoint;
}

SurfacePoint top_at(const Height& height, double x, double y) {
  const double slope_x = (height(x + kStep, y) - height(x - kStep, y)) / (2 * kStep);
  const double slope_y = (height(x, y + kStep) - height(x, y - kStep)) / (2 * kStep);
  return {{x, y, height(x, y)}, Eigen::Vector3d(-slope_x, -slope_y, 1).normalized()};
}

std::vector<Facet> facets_of(double width, double depth, const Inside& inside, const Height& height,
                             bool walls) {
  std::vector<Facet> facets;
  const int columns = static_cast<int>(std::lround(width / kCell));
  const int rows = static_cast<int>(std::lround(depth / kCell));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector2d low(column * kCell - width / 2, row * kCell - depth / 2);
      const Eigen::Vector2d middle = low + Eigen::Vector2d::Constant(kCell / 2);
      if (!inside(middle.x(), middle.y())) continue;
      const auto at = [=](double u, double v) {
        return top_at(height, low.x() + u * kCell, low.y() + v * kCell);
      };
      facets.push_back({kCell * kCell / at(0.5, 0.5).normal.z(), at});
      if (!walls) continue;
      for (const Eigen::Vector2d& out : {Eigen::Vector2d(1, 0), Eigen::Vector2d(-1, 0),
                                         Eigen::Vector2d(0, 1), Eigen::Vector2d(0, -1)}) {
        const Eigen::Vector2d next = middle + kCell * out;
        const bool within = std::abs(next.x()) < width / 2 && std::abs(next.y()) < depth / 2;
        if (within && inside(next.x(), next.y())) continue;
        const Eigen::Vector2d centre = middle + kCell / 2 * out;
        const Eigen::Vector2d along = kCell / 2 * Eigen::Vector2d(-out.y(), out.x());
        add_wall(height, centre - along, centre + along, out, facets);
      }
    }
  }
  return facets;
}

std::vector<Facet> patches(const Parametric& at, int columns, int rows, const Kept& kept) {
  std::vector<Facet> facets;
  const auto point_at = [at](double u, double v) {
    const Eigen::Vector3d along_u = (at(u + kStep, v) - at(u - kStep, v)) / (2 * kStep);
    const Eigen::Vector3d along_v = (at(u, v + kStep) - at(u, v - kStep)) / (2 * kStep);
    return std::pair<Eigen::Vector3d, Eigen::Vector3d>(at(u, v), along_u.cross(along_v));
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto [middle, normal] = point_at((column + 0.5) / columns, (row + 0.5) / rows);
      if (kept && !kept(middle)) continue;
      facets.push_back({normal.norm() / columns / rows, [=](double u, double v) {
                          const auto [position, out] =
                              point_at((column + u) / columns, (row + v) / rows);
                          return SurfacePoint{position, out.normalized()};
                        }});
    }
  }
  return facets;
}

Facet rectangle(const Eigen::Vector3d& corner, const Eigen::Vector3d& u_edge,
                const Eigen::Vector3d& v_edge) {
  return patches([=](double u, double v) { return corner + u * u_edge + v * v_edge; }, 1, 1)[0];
}

void append(const std::vector<Facet>& more, std::vector<Facet>& facets) {
  facets.insert(facets.end(), more.begin(), more.end());
}

ToolPath path_along(const std::function<SurfacePoint(double a)>& at) {
  ToolPath path;
  path.has_orientation = true;
  path.process_names = {"speed"};
  path.segments.push_back({"path", {}});
  for (std::size_t i = 0; i < kWaypoints; ++i) {
    const double a = (static_cast<double>(i) + 0.5) / kWaypoints;
    const Eigen::Vector3d along = at(a + kStep).position - at(a - kStep).position;
    path.segments[0].waypoints.push_back(waypoint_at(at(a), along));
  }
  return path;
}

Eigen::Vector2d around(double x, double y, double a) {
  double s = a * 4 * (x + y);
  if (s < 2 * x) return {-x + s, -y};
  if ((s -= 2 * x) < 2 * y) return {x, -y + s};
  if ((s -= 2 * y) < 2 * x) return {x - s, y};
  return {-x, y - (s - 2 * x)};
}

double half_diagonal(double width, double depth) {
  return std::hypot(width, depth) / 2;
}

}  // namespace cases
