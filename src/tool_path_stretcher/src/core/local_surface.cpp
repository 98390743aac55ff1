// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "local_surface.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

#include "robust.h"

namespace tool_path_stretcher {
namespace {

constexpr int kReweightings = 4;

}  // namespace

LocalSurfaceFitter::LocalSurfaceFitter(const Surface& reference, const Surface& object,
                                       const Mapping& mapping, double radius, int min_support)
    : reference_(reference),
      object_(object),
      mapping_(mapping),
      radius_(radius),
      min_support_(static_cast<std::size_t>(min_support)),
      residuals_(residuals_of(reference, mapping, object.points)) {}

std::vector<LocalSurfaceFitter::Height> LocalSurfaceFitter::heights_around(
    const LocalSurface& local, const Eigen::Vector3d& tangent,
    const Eigen::Vector3d& bitangent) const {
  constexpr double kSameFace = 0.8;  // cosine between the normals of one face
  const double scale = mapping_.similarity.scale;
  std::vector<KdTree::Neighbour> neighbours;
  object_.tree->within(mapping_ * local.base, radius_, neighbours);
  std::vector<Height> heights;
  for (const KdTree::Neighbour& neighbour : neighbours) {
    const Residual& residual = residuals_[neighbour.index];
    const double agreement = reference_.normals[residual.reference].dot(local.normal);
    const bool same_face =
        reference_.oriented ? agreement > kSameFace : std::abs(agreement) > kSameFace;
    if (!same_face || residual.beside > reference_.spacing) continue;
    const Eigen::Vector3d offset = residual.pulled_back - local.base;
    const double near = 1 - neighbour.squared_distance / (radius_ * radius_);
    heights.push_back(
        {scale * Eigen::Vector2d(offset.dot(tangent), offset.dot(bitangent)),
         scale * std::copysign(residual.along_normal, residual.along_normal * agreement), near});
  }
  return heights;
}

LocalSurface LocalSurfaceFitter::fit(const Eigen::Vector3d& point) const {
  LocalSurface local;
  const std::size_t nearest = reference_.tree->nearest(point).index;
  local.base = reference_.points[nearest];
  local.normal = reference_.normals[nearest];
  local.residual = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d tangent = local.normal.unitOrthogonal();
  const Eigen::Vector3d bitangent = local.normal.cross(tangent);
  const std::vector<Height> heights = heights_around(local, tangent, bitangent);
  local.support = heights.size();
  if (local.support < std::max<std::size_t>(min_support_, 4)) return local;

  double cut = std::numeric_limits<double>::infinity();
  Eigen::Vector3d solution = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kReweightings; ++i) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
    double weights = 0;
    double squares = 0;
    std::vector<double> errors;
    for (const Height& height : heights) {
      const Eigen::Vector3d row(1, height.at.x() / radius_, height.at.y() / radius_);
      const double error = height.height - row.dot(solution);
      const double weight = height.weight * (i == 0 ? 1 : tukey_weight(error, cut));
      matrix += weight * row * row.transpose();
      right_side += weight * height.height * row;
    }
    matrix.diagonal().array() += 1e-9 * matrix.trace() + 1e-12;
    inverse = matrix.inverse();
    solution = inverse * right_side;
    for (const Height& height : heights) {
      const Eigen::Vector3d row(1, height.at.x() / radius_, height.at.y() / radius_);
      errors.push_back(height.height - row.dot(solution));
      const double weight = height.weight * (i == 0 ? 1 : tukey_weight(errors.back(), cut));
      weights += weight;
      squares += weight * errors.back() * errors.back();
    }
    local.residual = std::sqrt(squares / std::max(weights, 1e-12));
    cut = kTukeyCut * robust_deviation(errors) + 1e-9;
  }
  // Errors of neighbouring points are not quite independent: part of the noise stays.
  constexpr double kCommon = 0.1;
  const double variance = local.residual * local.residual;
  local.height = solution[0];
  local.height_variance = variance * (inverse(0, 0) + kCommon * kCommon);
  local.slope = (solution[1] * tangent + solution[2] * bitangent) / radius_;
  local.slope_variance =
      variance * (0.5 * (inverse(1, 1) + inverse(2, 2)) + kCommon * kCommon) / (radius_ * radius_);
  // Points on one side only tell little of the height here.
  constexpr double kMostVariance = 0.5;
  local.measured = inverse(0, 0) < kMostVariance;
  return local;
}

}  // namespace tool_path_stretcher
