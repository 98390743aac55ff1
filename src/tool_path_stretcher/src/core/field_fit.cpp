// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <cmath>

#include "robust.h"
#include "tool_path_stretcher/deformation.h"
#include "tool_path_stretcher/residuals.h"

namespace tool_path_stretcher {
namespace {

constexpr std::size_t kFitPoints = 6000;
constexpr int kIterations = 6;
constexpr double kReach = 2;  // spacings beside the reference, beyond which a point is none of it
constexpr double kRidge = 1e-4;  // of the weight of a point: what the data do not show stays zero
constexpr double kLeastGain = 0.05;  // of the held-out residual, for a higher degree to be kept

/// Signed residuals of the points that lie on the reference.
std::vector<double> signed_residuals(const std::vector<Residual>& residuals, double spacing) {
  std::vector<double> result;
  for (const Residual& residual : residuals) {
    if (residual.beside < kReach * spacing) result.push_back(residual.along_normal);
  }
  return result;
}

/// One Gauss-Newton step on the whole field, reweighted for outliers.
void improve(const Surface& reference, const Points& object_points, Mapping& mapping) {
  const std::vector<Residual> residuals = residuals_of(reference, mapping, object_points);
  const double cut =
      kTukeyCut * robust_deviation(signed_residuals(residuals, reference.spacing)) + 1e-12;
  const auto terms = static_cast<Eigen::Index>(mapping.field.terms());
  Eigen::MatrixXd normal_matrix = Eigen::MatrixXd::Zero(3 * terms, 3 * terms);
  Eigen::VectorXd right_side = Eigen::VectorXd::Zero(3 * terms);
  Eigen::VectorXd basis;
  Eigen::VectorXd row(3 * terms);
  double total_weight = 0;
  for (const Residual& residual : residuals) {
    if (residual.beside >= kReach * reference.spacing) continue;
    const double weight = tukey_weight(residual.along_normal, cut);
    if (weight == 0) continue;
    mapping.field.basis(residual.pulled_back, basis);
    const Eigen::Vector3d& normal = reference.normals[residual.reference];
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      row.segment(axis * terms, terms) = normal[axis] * basis;
    normal_matrix.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
    right_side += weight * residual.along_normal * row;
    total_weight += weight;
  }
  // The ridge pulls the whole field towards zero, not only the step.
  const double ridge = kRidge * total_weight + 1e-12;
  Eigen::Matrix3Xd& coefficients = mapping.field.coefficients();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    right_side.segment(axis * terms, terms) -= ridge * coefficients.row(axis).transpose();
  }
  normal_matrix.diagonal().array() += ridge;
  const Eigen::VectorXd step =
      normal_matrix.selfadjointView<Eigen::Lower>().ldlt().solve(right_side);
  if (!step.allFinite()) return;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    coefficients.row(axis) += step.segment(axis * terms, terms).transpose();
}

Mapping fit(const Surface& reference, const Points& object_points, const Similarity& similarity,
            const PrincipalFrame& frame, int degree) {
  Mapping mapping{similarity, SmoothField(frame, degree)};
  for (int i = 0; i < kIterations; ++i)
    improve(reference, object_points, mapping);
  return mapping;
}

/// Root mean square of the residuals, each counted up to `cut`.
double capped_rms(const Surface& reference, const Mapping& mapping, const Points& object_points,
                  double cut) {
  const std::vector<double> residuals =
      signed_residuals(residuals_of(reference, mapping, object_points), reference.spacing);
  double sum = 0;
  for (const double residual : residuals)
    sum += std::min(residual * residual, cut * cut);
  return residuals.empty() ? cut : std::sqrt(sum / static_cast<double>(residuals.size()));
}

/// Every other block of a chequerboard in space: neighbours share their errors, so that single
/// points held out would not tell noise from shape.
void split_in_blocks(const Points& points, double edge, Points& first, Points& second) {
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d cell = (point / edge).array().floor();
    const bool odd = std::fmod(std::abs(cell.sum()), 2) == 1;
    (odd ? first : second).push_back(point);
  }
}

}  // namespace

SmoothField fit_smooth_field(const Surface& reference, const Surface& object,
                             const Similarity& similarity, int highest_degree) {
  constexpr double kBlocksAcross = 12;
  constexpr std::size_t kPointsPerUnknown = 10;
  const PrincipalFrame frame = principal_frame(reference.points);
  const Points points = select(object.points, spread_evenly(object.points, kFitPoints));
  Points training;
  Points held_out;
  split_in_blocks(points, 4 * object.size / kBlocksAcross, training, held_out);
  const Mapping rigid{similarity, {}};
  const double cut = 3 * robust_deviation(signed_residuals(residuals_of(reference, rigid, held_out),
                                                           reference.spacing));
  double best = capped_rms(reference, rigid, held_out, cut);
  int justified = 0;
  for (int degree = 2; degree <= highest_degree; ++degree) {
    if (training.size() < kPointsPerUnknown * 3 * SmoothField(frame, degree).terms()) break;
    const Mapping mapping = fit(reference, training, similarity, frame, degree);
    const double error = capped_rms(reference, mapping, held_out, cut);
    if (!(error < (1 - kLeastGain) * best)) continue;
    best = error;
    justified = degree;
  }
  if (justified == 0) return {};
  return fit(reference, points, similarity, frame, justified).field;
}

}  // namespace tool_path_stretcher
