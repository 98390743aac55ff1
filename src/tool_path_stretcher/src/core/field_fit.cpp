// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <cmath>

#include "robust.h"
#include "tool_path_stretcher/deformation.h"
#include "tool_path_stretcher/residuals.h"

namespace tool_path_stretcher {
namespace {

constexpr int kIterations = 6;
constexpr double kReach = 2;  // spacings beside the reference, beyond which a point is none of it
constexpr double kPrior = 0.02;      // of the size: how large a coefficient may well be
constexpr double kLeastGain = 0.05;  // of the held-out residual, for a higher degree to be kept

/// Signed residuals of the points that lie on the reference.
std::vector<double> signed_residuals(const std::vector<Residual>& residuals, double spacing) {
  std::vector<double> result;
  for (const Residual& residual : residuals) {
    if (residual.beside < kReach * spacing) result.push_back(residual.along_normal);
  }
  return result;
}

/// A point that the field should move by `error` along `direction`, in the reference's frame.
struct Constraint {
  Eigen::Vector3d at;
  Eigen::Vector3d direction;  // unit length
  double error;               // [m]
};
using Constraints = std::vector<Constraint>;

Constraints along_normals(const Surface& reference, const Mapping& mapping,
                          const Points& object_points) {
  Constraints constraints;
  for (const Residual& residual : residuals_of(reference, mapping, object_points)) {
    if (residual.beside >= kReach * reference.spacing) continue;
    constraints.push_back(
        {residual.pulled_back, reference.normals[residual.reference], residual.along_normal});
  }
  return constraints;
}

Constraints along_rims(const Surface& reference, const Mapping& mapping, const Points& object_rim) {
  constexpr double kRimReach = 0.1;  // of the reference's size
  Constraints constraints;
  if (!reference.rim.tree) return constraints;
  for (const Eigen::Vector3d& point : object_rim) {
    const Eigen::Vector3d at = mapping.pull_back(point);
    const auto nearest = reference.rim.tree->nearest(at);
    if (nearest.squared_distance > std::pow(kRimReach * reference.size, 2)) continue;
    const Eigen::Vector3d& outward = reference.rim.outward[nearest.index];
    constraints.push_back({at, outward, outward.dot(at - reference.rim.points[nearest.index])});
  }
  return constraints;
}

double deviation_of(const Constraints& constraints) {
  std::vector<double> errors;
  errors.reserve(constraints.size());
  for (const Constraint& constraint : constraints)
    errors.push_back(constraint.error);
  return robust_deviation(std::move(errors));
}

/// Normal equations of the field's coefficients, the three components one after the other.
class FieldEquations {
 public:
  explicit FieldEquations(const SmoothField& field)
      : terms_(static_cast<Eigen::Index>(field.terms())),
        matrix_(Eigen::MatrixXd::Zero(3 * terms_, 3 * terms_)),
        right_side_(Eigen::VectorXd::Zero(3 * terms_)) {}

  /// Each constraint counts by its deviation [m], and not at all far beyond it.
  void add(const Constraints& constraints, const SmoothField& field, double deviation) {
    Eigen::VectorXd basis;
    Eigen::VectorXd row(3 * terms_);
    for (const Constraint& constraint : constraints) {
      const double weight =
          tukey_weight(constraint.error, kTukeyCut * deviation) / (deviation * deviation);
      if (weight == 0) continue;
      field.basis(constraint.at, basis);
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        row.segment(axis * terms_, terms_) = constraint.direction[axis] * basis;
      matrix_.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
      right_side_ += weight * constraint.error * row;
    }
  }

  /// Moves the coefficients. The prior pulls the whole field towards zero, not only the step, so
  /// that what the data do not show stays zero.
  /// @param prior [m] standard deviation of a coefficient
  void solve(SmoothField& field, double prior) {
    const double ridge = 1 / (prior * prior);
    Eigen::Matrix3Xd& coefficients = field.coefficients();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      right_side_.segment(axis * terms_, terms_) -= ridge * coefficients.row(axis).transpose();
    }
    matrix_.diagonal().array() += ridge;
    const Eigen::VectorXd step = matrix_.selfadjointView<Eigen::Lower>().ldlt().solve(right_side_);
    if (!step.allFinite()) return;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      coefficients.row(axis) += step.segment(axis * terms_, terms_).transpose();
  }

 private:
  Eigen::Index terms_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd right_side_;
};

Mapping fit(const Surface& reference, const Points& object_points, const Points& object_rim,
            const Similarity& similarity, const PrincipalFrame& frame, int degree) {
  constexpr double kRimDeviation = 0.5;  // spacings: how far inside its rim a surface is sampled
  Mapping mapping{similarity, SmoothField(frame, degree)};
  for (int i = 0; i < kIterations; ++i) {
    const Constraints normals = along_normals(reference, mapping, object_points);
    const Constraints rims = along_rims(reference, mapping, object_rim);
    FieldEquations equations(mapping.field);
    equations.add(normals, mapping.field, std::max(deviation_of(normals), 1e-7 * reference.size));
    equations.add(rims, mapping.field,
                  std::max(deviation_of(rims), kRimDeviation * reference.spacing));
    equations.solve(mapping.field, kPrior * reference.size);
  }
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

/// The similarity that comes nearest to a mapping on the reference.
Similarity nearest_similarity(const Surface& reference, const Mapping& mapping) {
  Points from = select(reference.points, reference.samples.few);
  Points to;
  for (const Eigen::Vector3d& point : from)
    to.push_back(mapping * point);
  return fit_similarity(from, to);
}

/// Fits a field about the similarity that it comes nearest to: what is pose and size should not be
/// taken for deformation.
Mapping fit_twice(const Surface& reference, const Points& object_points, const Points& object_rim,
                  const Similarity& similarity, const PrincipalFrame& frame, int degree) {
  const Mapping first = fit(reference, object_points, object_rim, similarity, frame, degree);
  return fit(reference, object_points, object_rim, nearest_similarity(reference, first), frame,
             degree);
}

}  // namespace

Mapping fit_smooth_field(const Surface& reference, const Surface& object,
                         const Similarity& similarity, int highest_degree) {
  constexpr double kBlocksAcross = 12;
  constexpr std::size_t kPointsPerUnknown = 10;
  const PrincipalFrame frame = principal_frame(reference.points);
  const Points points = select(object.points, object.samples.many);
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
    const Mapping mapping =
        fit_twice(reference, training, object.rim.points, similarity, frame, degree);
    const double error = capped_rms(reference, mapping, held_out, cut);
    if (!(error < (1 - kLeastGain) * best)) continue;
    best = error;
    justified = degree;
  }
  if (justified == 0) return rigid;
  return fit_twice(reference, points, object.rim.points, similarity, frame, justified);
}

}  // namespace tool_path_stretcher
