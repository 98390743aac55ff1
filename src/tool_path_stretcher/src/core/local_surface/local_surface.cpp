// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "local_surface/local_surface.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/kd_tree.h"
#include "geometry/robust.h"

namespace tool_path_stretcher {
LocalSurfaceFitter::LocalSurfaceFitter(const SurfacePair& surfaces, const Mapping& mapping,
                                       double radius, int min_support, double max_stranger)
    : reference_(surfaces.reference),
      object_(surfaces.object),
      mapping_(mapping),
      radius_(radius),
      min_support_(static_cast<std::size_t>(min_support)),
      residuals_(residuals_of(reference_, mapping, object_.points)),
      strangers_(surfaces, mapping, residuals_, max_stranger) {
  std::vector<double> along;
  along.reserve(residuals_.size());
  for (const Residual& residual : residuals_)
    along.push_back(mapping.similarity.scale * residual.along_normal);
  constexpr double kExact = 1e-9;  // [m] keeps the noise above 0 for identical clouds; chosen
  noise_ = std::max(robust_deviation(std::move(along)), kExact);
}

std::vector<LocalSurfaceFitter::Height> LocalSurfaceFitter::heights_of(
    const std::vector<KdTree::Neighbour>& neighbours, const LocalSurface& local,
    const Eigen::Vector3d& tangent, const Eigen::Vector3d& bitangent) const {
  constexpr double kSameFace = 0.8;  // cosine between the normals of one face; chosen
  const double scale = mapping_.similarity.scale;
  std::vector<Height> heights;
  for (const KdTree::Neighbour& neighbour : neighbours) {
    const Residual& residual = residuals_[neighbour.index];
    const double agreement = reference_.normals[residual.reference].dot(local.normal);
    const bool same_face =
        reference_.oriented ? agreement > kSameFace : std::abs(agreement) > kSameFace;
    // Over a hole of the reference, its surface is unknown.
    if (!same_face || residual.beside > 0) continue;
    const Eigen::Vector3d offset = residual.pulled_back - local.base;
    const double near = 1 - neighbour.squared_distance / (radius_ * radius_);
    const double sign = std::copysign(1.0, agreement);
    const Eigen::Vector3d normal = sign * reference_.normals[residual.reference];
    heights.push_back({scale * Eigen::Vector2d(offset.dot(tangent), offset.dot(bitangent)),
                       scale * sign * residual.along_normal,
                       near,
                       scale * reference_.blur[residual.reference] + object_.blur[neighbour.index],
                       {normal.dot(tangent), normal.dot(bitangent)}});
  }
  weigh_down_edges(heights);
  return heights;
}

void LocalSurfaceFitter::weigh_down_edges(std::vector<Height>& heights) const {
  constexpr double kDeviations = 3;  // the farthest of eight neighbours on a face
  constexpr double kTypical = 2;     // medians: as on the rest of a curved face; chosen
  std::vector<double> blurs;
  for (const Height& each : heights)
    blurs.push_back(each.blur);
  const double usual = std::max(kDeviations * noise_, kTypical * quantile(std::move(blurs), 0.5));
  for (Height& each : heights) {
    const double beyond = std::max(0.0, each.blur - usual);
    each.weight *= noise_ * noise_ / (noise_ * noise_ + beyond * beyond);
  }
}

namespace {

/// A plane through heights: solution[0] + (solution[1] x + solution[2] y) / radius.
struct LinearFit {
  Eigen::Vector3d solution = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();  // of the normal equations
  double rms = 0;                                     // [m] weighted
  double points = 0;                                  // effective number (Kish 1965)
};

/// Other properties of a fit's points, fitted like their heights; per radius.
struct Gradients {
  Eigen::Matrix2d
      of_rise;  // one column per direction: rotation of the plane with a shift of the scan
  Eigen::Vector2d of_blur;  // beyond what is usual on a face
};

template <class Heights>
Gradients gradients_of(const Heights& heights, double radius, const Eigen::Matrix3d& inverse,
                       double usual) {
  Eigen::Matrix3d right_sides = Eigen::Matrix3d::Zero();
  for (const auto& height : heights) {
    const Eigen::Vector3d row(1, height.at.x() / radius, height.at.y() / radius);
    right_sides +=
        height.weight * row *
        Eigen::RowVector3d(height.rise.x(), height.rise.y(), std::max(0.0, height.blur - usual));
  }
  const Eigen::Matrix<double, 2, 3> slopes = (inverse * right_sides).bottomRows<2>();
  return {slopes.leftCols<2>(), slopes.col(2)};
}

template <class Heights>
LinearFit fit_linearly(const Heights& heights, double radius) {
  constexpr int kReweightings = 4;  // chosen
  LinearFit fit;
  double cut = std::numeric_limits<double>::infinity();
  const auto row_of = [radius](const auto& height) {
    return Eigen::Vector3d(1, height.at.x() / radius, height.at.y() / radius);
  };
  for (int i = 0; i < kReweightings; ++i) {
    Eigen::Matrix3d matrix = 1e-9 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
    for (const auto& height : heights) {
      const Eigen::Vector3d row = row_of(height);
      const double weight =
          height.weight * tukey_weight(height.height - row.dot(fit.solution), cut);
      matrix += weight * row * row.transpose();
      right_side += weight * height.height * row;
    }
    fit.inverse = matrix.inverse();
    fit.solution = fit.inverse * right_side;
    std::vector<double> errors;
    for (const auto& height : heights)
      errors.push_back(height.height - row_of(height).dot(fit.solution));
    cut = kTukeyCut * robust_deviation(errors) + 1e-9;
    double weights = 1e-12;
    double of_weights = 1e-24;
    double squares = 0;
    for (std::size_t k = 0; k < errors.size(); ++k) {
      const double weight = heights[k].weight * tukey_weight(errors[k], cut);
      weights += weight;
      of_weights += weight * weight;
      squares += weight * errors[k] * errors[k];
    }
    fit.rms = std::sqrt(squares / weights);
    fit.points = weights * weights / of_weights;
  }
  return fit;
}

/// Variance of each component of the slope due to a shift.
/// @param slopes of the fit per metre of shift in each of two directions
/// @param covariance [m^2] of the shift; beyond the radius it concerns the mapping, not the fit
double slope_variance_of_shift(const Eigen::Matrix2d& slopes, const Eigen::Matrix2d& covariance,
                               double radius) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance);
  const Eigen::Vector2d variances = solver.eigenvalues().cwiseMax(0).cwiseMin(radius * radius);
  return (slopes * solver.eigenvectors() * variances.cwiseSqrt().asDiagonal()).squaredNorm() / 2;
}

/// The same due to what rounds off the scan towards an edge, where it falls off the reference:
/// sampling and mixed points.
/// @param of_blur [m] growth of the blur over the radius in each of two directions
double slope_variance_of_blur(const Eigen::Vector2d& of_blur, double radius) {
  constexpr double kRounded = 0.3;  // of the growth of the blur; chosen
  const double rounded = kRounded * of_blur.norm();
  return rounded * rounded / 2 / (radius * radius);
}

}  // namespace

LocalSurface LocalSurfaceFitter::far_from(const Eigen::Vector3d& point) const {
  LocalSurface local;
  const std::size_t nearest = reference_.tree->nearest(point).index;
  local.base = reference_.points[nearest];
  local.normal = reference_.normals[nearest];
  local.residual = std::numeric_limits<double>::quiet_NaN();
  return local;
}

/// If the reference is the visible part of a surface: whether `point` lies beside the hidden part,
/// and at which place on it.
bool LocalSurfaceFitter::lies_on_hidden(const Eigen::Vector3d& point, LocalSurface& local) const {
  constexpr double kBeside = 2;  // spacings, as in distances_of()
  if (!reference_.whole) return false;
  const KdTree::Neighbour nearest = reference_.whole->nearest(point);
  const double least = std::sqrt(nearest.squared_distance);
  if ((point - local.base).norm() <= least + kBeside * reference_.spacing) return false;
  local.base = reference_.whole->points()[nearest.index];
  local.normal = reference_.whole_normals[nearest.index];
  return true;
}

LocalSurface LocalSurfaceFitter::fit(const Eigen::Vector3d& point,
                                     const Eigen::Matrix3d& shift_covariance) const {
  LocalSurface local = far_from(point);
  if (lies_on_hidden(point, local)) return local;
  const Eigen::Vector3d tangent = local.normal.unitOrthogonal();
  const Eigen::Vector3d bitangent = local.normal.cross(tangent);
  std::vector<KdTree::Neighbour> neighbours;
  object_.tree->within(mapping_ * local.base, radius_, neighbours);
  const std::vector<Height> heights = heights_of(neighbours, local, tangent, bitangent);
  local.support = heights.size();
  local.strangers = strangers_.beside(mapping_ * local.base,
                                      mapping_.turn(local.base, local.normal) * local.normal,
                                      radius_, local.support >= min_support_);
  if (local.support < min_support_) return local;

  const LinearFit fit = fit_linearly(heights, radius_);
  local.residual = fit.rms;
  local.height = fit.solution[0];
  local.slope = (fit.solution[1] * tangent + fit.solution[2] * bitangent) / radius_;
  // Errors of neighbouring points are not quite independent: part of the noise remains.
  constexpr double kCommon = 0.1 * 0.1;  // of the variance; chosen
  constexpr double kFitted = 3;          // numbers of a plane
  const double freedom = std::max(0.1, 1 - kFitted / fit.points);
  const double variance = fit.rms * fit.rms / freedom;
  local.height_variance = variance * (fit.inverse(0, 0) + kCommon);
  local.slope_variance =
      variance * (0.5 * (fit.inverse(1, 1) + fit.inverse(2, 2)) + kCommon) / (radius_ * radius_);
  Eigen::Matrix<double, 3, 2> ways;
  ways << tangent, bitangent;
  ways = mapping_.similarity.rotation * ways;
  constexpr double kDeviations = 3;  // the farthest of eight neighbours on a face
  const Gradients gradients = gradients_of(heights, radius_, fit.inverse, kDeviations * noise_);
  local.slope_variance += slope_variance_of_shift(
      gradients.of_rise / radius_, ways.transpose() * shift_covariance * ways, radius_);
  local.slope_variance += slope_variance_of_blur(gradients.of_blur, radius_);
  // Points on only one side tell little about the height here, and points of two faces nothing.
  constexpr double kMaxLeverage = 0.5;  // of a point's variance in the height; chosen
  constexpr double kRough = 5;          // times the noise; chosen
  local.measured =
      fit.inverse(0, 0) < kMaxLeverage && fit.rms < kRough * noise_ && fit.points > kFitted + 1;
  return local;
}

}  // namespace tool_path_stretcher
