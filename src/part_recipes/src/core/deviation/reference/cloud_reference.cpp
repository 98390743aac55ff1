// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "deviation/reference/cloud_reference.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tool_path_stretcher/surface.h"

namespace part_recipes {
namespace {

using Eigen::Vector3d;
using scan_cell_common::PointTree;
using Height = Eigen::Matrix<double, 6, 1>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kNeighbours = 24;  // four times the numbers of a quadratic; chosen
constexpr double kSameFace = 0.866;      // cosine: 30 degrees between the normals; chosen
constexpr double kGrazing = 0.0872;      // cosine: 85 degrees from the viewer; chosen

Height terms_of(double x, double y) {
  Height terms;
  terms << 1, x, y, x * x, x * y, y * y;
  return terms;
}

/// The normal on the side that a viewer sees.
/// @param towards the viewers, unit length
/// @param[out] known false if all of them look along the surface
Vector3d outwards(const Vector3d& normal, const std::vector<Vector3d>& towards, bool& known) {
  double most = 0;
  for (const Vector3d& direction : towards) {
    const double facing = normal.dot(direction);
    if (std::abs(facing) > std::abs(most)) most = facing;
  }
  known = std::abs(most) > kGrazing;
  return most < 0 ? Vector3d(-normal) : normal;
}

Eigen::Matrix3d axes_about(const Vector3d& normal) {
  Eigen::Matrix3d axes;
  axes.col(0) = normal.unitOrthogonal();
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return axes;
}

/// Least squares over the neighbours on the same face; flat if they are too few.
void fit(const ReferenceSurface::Samples& samples, const PointTree& tree, std::size_t at,
         SurfacePiece& piece) {
  std::array<PointTree::Index, kNeighbours> found{};
  std::array<double, kNeighbours> squared{};
  const Vector3d& origin = samples.points[at];
  const std::size_t count = tree.nearest(origin.data(), kNeighbours, found.data(), squared.data());
  Eigen::Matrix<double, 6, 6> normal_matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Height right = Height::Zero();
  std::size_t used = 0;
  const double unit = samples.spacing;  // keeps the equations well scaled
  for (std::size_t i = 0; i < count; ++i) {
    if (std::abs(samples.normals[found[i]].dot(samples.normals[at])) < kSameFace) {
      piece.beside_edge = true;
      continue;
    }
    const Vector3d local = piece.axes.transpose() * (samples.points[found[i]] - origin) / unit;
    const Height terms = terms_of(local.x(), local.y());
    normal_matrix += terms * terms.transpose();
    right += local.z() * terms;
    ++used;
  }
  constexpr std::size_t kFewest = 12;  // twice the numbers of a quadratic; chosen
  if (used < kFewest) return;
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(normal_matrix);
  constexpr double kSingular = 1e-8;  // reciprocal condition: all on a line; chosen
  if (solver.rcond() < kSingular) return;
  piece.height = solver.solve(right);
  piece.height.head<1>() *= unit;
  piece.height.tail<3>() /= unit;
}

ReferenceSurface::Samples samples_of(const tool_path_stretcher::Surface& surface) {
  ReferenceSurface::Samples samples{surface.points, surface.normals, surface.spacing};
  std::vector<Vector3d> towards = surface.seen_from;
  if (towards.empty()) towards.push_back(Vector3d::UnitZ());
  for (Vector3d& normal : samples.normals) {
    bool known = false;
    normal = outwards(normal, towards, known);
  }
  return samples;
}

}  // namespace

CloudReference::CloudReference(const tool_path_stretcher::Surface& surface)
    : ReferenceSurface(samples_of(surface), surface.seen_from.empty()
                                                ? OutsideKnownBy::kUpwards
                                                : OutsideKnownBy::kViewpoints),
      tree_(samples().points),
      pieces_(samples().points.size()) {
  std::vector<Vector3d> towards = surface.seen_from;
  if (towards.empty()) towards.push_back(Vector3d::UnitZ());
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    pieces_[i].axes = axes_about(samples().normals[i]);
    outwards(samples().normals[i], towards, pieces_[i].outside_known);
    fit(samples(), tree_, i, pieces_[i]);
  }
}

double CloudReference::distance_from(std::size_t index, const Vector3d& point,
                                     const Reach& reach) const {
  const SurfacePiece& piece = pieces_[index];
  const Vector3d local = piece.axes.transpose() * (point - samples().points[index]);
  const double beyond = samples().spacing + reach.lateral;
  if (!piece.outside_known || local.head<2>().norm() > beyond) return kNaN;
  const auto& height = piece.height;
  const double over = local.z() - height.dot(terms_of(local.x(), local.y()));
  const double slope_x = height[1] + 2 * height[3] * local.x() + height[4] * local.y();
  const double slope_y = height[2] + height[4] * local.x() + 2 * height[5] * local.y();
  // The distance to the tangent plane below the point (Taubin 1991, first order)
  const double distance = over / std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
  return std::abs(distance) <= reach.normal ? distance : kNaN;
}

double CloudReference::signed_distance(const Vector3d& point, const Reach& reach) const {
  constexpr std::size_t kFaces = 8;  // around an edge; chosen
  std::array<PointTree::Index, kFaces> found{};
  std::array<double, kFaces> squared{};
  tree_.nearest(point.data(), 1, found.data(), squared.data());
  if (!pieces_[found[0]].beside_edge) return distance_from(found[0], point, reach);
  // Beside an edge the nearest sample may belong to the other face
  const std::size_t count = tree_.nearest(point.data(), kFaces, found.data(), squared.data());
  double best = kNaN;
  for (std::size_t i = 0; i < count; ++i) {
    const double distance = distance_from(found[i], point, reach);
    if (!(std::abs(distance) >= std::abs(best)) && !std::isnan(distance)) best = distance;
  }
  return best;
}

}  // namespace part_recipes
