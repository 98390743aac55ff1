// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "alignment/refinement.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <optional>

#include "cores/by_index.h"
#include "geometry/facing.h"
#include "geometry/nearest_cache.h"
#include "geometry/points.h"
#include "geometry/robust.h"
#include "mapping/residuals.h"
#include "surface/edges.h"

namespace tool_path_stretcher {
namespace {

using Vector7d = Eigen::Matrix<double, 7, 1>;
using Matrix7d = Eigen::Matrix<double, 7, 7>;

/// A point of the mapped reference that should move by `error` along `direction`, in the object's
/// frame.
struct Constraint {
  Eigen::Vector3d point;
  Eigen::Vector3d direction;  // unit length
  double error;               // [m]
};
using Constraints = std::vector<Constraint>;

/// The distance from a mapped reference point to an object point along the first normal. None
/// unless the two may be the same place: close to each other laterally, on surfaces that face
/// alike.
std::optional<Constraint> pair_of(const Eigen::Vector3d& mapped, const Eigen::Vector3d& object,
                                  const Eigen::Vector3d& normal,
                                  const Eigen::Vector3d& other_normal, double spacing) {
  constexpr double kReach = 4;         // spacings; chosen
  constexpr double kFacesAlike = 0.7;  // cosine: up to 46 degrees; chosen
  if (std::abs(normal.dot(other_normal)) < kFacesAlike) return {};
  const Eigen::Vector3d way = object - mapped;
  const double along = normal.dot(way);
  const double beside = (way - along * normal).norm();
  if (beside >= kReach * spacing) return {};
  return Constraint{mapped, normal, along};
}

/// Pairs the points of two surfaces in both directions while one moves towards the other.
class Pairing {
 public:
  Pairing(const SurfacePair& surfaces, Density density)
      : reference_(surfaces.reference),
        object_(surfaces.object),
        object_sample_(object_.samples.of(density)),
        reference_sample_(reference_.samples.of(density)),
        in_reference_(*reference_.tree, object_sample_.size(), reference_.spacing),
        in_object_(*object_.tree, reference_sample_.size(), object_.spacing) {
    if (!reference_.edges.tree) return;
    constexpr std::size_t kEdgeShare = 3;  // one part of the sample; chosen
    edge_sample_ = spread_evenly(object_.edges.points, object_sample_.size() / kEdgeShare);
  }

  Constraints object_to_reference(const Similarity& similarity) {
    return all_of<Constraint>(object_sample_.size(), kHundreds, [&](std::size_t k) {
      const std::size_t i = object_sample_[k];
      const std::size_t nearest = in_reference_.nearest(k, similarity.inverse(object_.points[i]));
      return pair_of(similarity * reference_.points[nearest], object_.points[i],
                     similarity.rotation * reference_.normals[nearest], object_.normals[i],
                     similarity.scale * reference_.spacing);
    });
  }

  Constraints reference_to_object(const Similarity& similarity) {
    return all_of<Constraint>(reference_sample_.size(), kHundreds, [&](std::size_t k) {
      const std::size_t i = reference_sample_[k];
      const Eigen::Vector3d mapped = similarity * reference_.points[i];
      const std::size_t nearest = in_object_.nearest(k, mapped);
      return pair_of(mapped, object_.points[nearest], object_.normals[nearest],
                     similarity.rotation * reference_.normals[i], object_.spacing);
    });
  }

  /// The object's edges should lie on the reference's, but may slide along them.
  Constraints edge_to_edge(const Similarity& similarity) const {
    constexpr double kReach = 0.08;  // of the object's size; chosen
    const Rim& edges = reference_.edges;
    return all_of<Constraint>(
        edge_sample_.size(), kHundreds, [&](std::size_t k) -> std::optional<Constraint> {
          const std::size_t i = edge_sample_[k];
          const Eigen::Vector3d& point = object_.edges.points[i];
          const Eigen::Vector3d facing = similarity.rotation.transpose() * object_.edges.outward[i];
          const auto nearest = edge_facing(edges, similarity.inverse(point), facing);
          if (!nearest || edges.horizon[*nearest]) return {};
          const Eigen::Vector3d mapped = similarity * edges.points[*nearest];
          if ((point - mapped).norm() > kReach * object_.size) return {};
          const Eigen::Vector3d outward = similarity.rotation * edges.outward[*nearest];
          return Constraint{mapped, outward, outward.dot(point - mapped)};
        });
  }

 private:
  const Surface& reference_;
  const Surface& object_;
  const std::vector<std::size_t>& object_sample_;
  const std::vector<std::size_t>& reference_sample_;
  std::vector<std::size_t> edge_sample_;  // of the object; empty if the reference has no edge
  NearestCache in_reference_;
  NearestCache in_object_;
};

double deviation_of(const Constraints& constraints, double least) {
  std::vector<double> errors;
  errors.reserve(constraints.size());
  for (const Constraint& constraint : constraints)
    errors.push_back(constraint.error);
  return std::max(robust_deviation(std::move(errors)), least);
}

/// Normal equations of a small similarity about `centre`: rotation, shift, relative growth.
class Equations {
 public:
  explicit Equations(const Eigen::Vector3d& centre) : centre_(centre) {}

  /// Weights each constraint by the deviation [m]; errors far beyond it do not count.
  void add(const Constraints& constraints, double deviation) {
    for (const Constraint& constraint : constraints) {
      const double weight =
          tukey_weight(constraint.error, kTukeyCut * deviation) / (deviation * deviation);
      if (weight == 0) continue;
      const Eigen::Vector3d arm = constraint.point - centre_;
      Vector7d row;
      row << arm.cross(constraint.direction), constraint.direction, arm.dot(constraint.direction);
      matrix_ += weight * row * row.transpose();
      right_side_ += weight * constraint.error * row;
    }
  }

  /// The two rigid motions that the constraints resist least. They move a point at the given
  /// distance by at most one metre.
  std::array<Vector7d, 2> weakest(double distance) const {
    Eigen::Matrix<double, 6, 6> matrix = matrix_.topLeftCorner<6, 6>();
    matrix.topRows<3>() /= distance;
    matrix.leftCols<3>() /= distance;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(matrix);
    std::array<Vector7d, 2> motions;
    for (Eigen::Index i = 0; i < 2; ++i) {
      Vector7d& motion = motions[static_cast<std::size_t>(i)];
      motion << solver.eigenvectors().col(i).head<3>() / distance,
          solver.eigenvectors().col(i).tail<3>(), 0;
    }
    return motions;
  }

  /// Adds the prior knowledge of the object's scale, which is now `current`.
  void add_prior(const ScalePrior& prior, double current) {
    fixed_scale_ = prior.is_fixed();
    if (!prior.is_known() || fixed_scale_) return;
    const double deviation = prior.deviation / current;
    matrix_(6, 6) += 1 / (deviation * deviation);
    right_side_[6] += std::log(prior.value / current) / (deviation * deviation);
  }

  Vector7d solve() const {
    constexpr double kDamping = 1e-9;  // pins what the surfaces do not show
    Matrix7d matrix = matrix_;
    for (int i = 0; i < 7; ++i)
      matrix(i, i) += kDamping * matrix_(i, i) + 1e-12;
    Vector7d step = Vector7d::Zero();
    if (fixed_scale_) {
      step.head<6>() = matrix.topLeftCorner<6, 6>().ldlt().solve(right_side_.head<6>());
    } else {
      step = matrix.ldlt().solve(right_side_);
    }
    return step.allFinite() ? step : Vector7d::Zero();
  }

 private:
  Eigen::Vector3d centre_;
  Matrix7d matrix_ = Matrix7d::Zero();
  Vector7d right_side_ = Vector7d::Zero();
  bool fixed_scale_ = false;
};

Similarity moved(const Similarity& similarity, const Eigen::Vector3d& centre,
                 const Vector7d& step) {
  const double angle = step.head<3>().norm();
  const Eigen::Matrix3d turn =
      angle > 0 ? Eigen::AngleAxisd(angle, step.head<3>() / angle).toRotationMatrix()
                : Eigen::Matrix3d::Identity();
  constexpr double kMaxGrowth = 0.1;  // of the scale in a step; chosen
  const double growth = std::exp(std::clamp(step[6], -kMaxGrowth, kMaxGrowth));
  Similarity result;
  result.scale = growth * similarity.scale;
  result.rotation = Eigen::Quaterniond(turn * similarity.rotation).normalized().toRotationMatrix();
  result.translation =
      growth * (turn * (similarity.translation - centre)) + centre + step.segment<3>(3);
  return result;
}

}  // namespace

Similarity refine(const SurfacePair& surfaces, Similarity start, const ScalePrior& scale,
                  Density density, int iterations) {
  // [rad], of the object's size and of the scale, summed; chosen
  const double converged = density == Density::kMany ? 1e-6 : 3e-5;
  constexpr double kConverged = 0.01;    // of the residuals' deviation: the mean is known no better
  constexpr double kRimDeviation = 0.5;  // spacings: how far inside its rim a surface is sampled
  const Surface& object = surfaces.object;
  const Eigen::Vector3d centre = object.centroid;
  // Without noise, faces fit far better than sampled edges and holes. These must not become
  // outliers, since they may be all that shows a rotation.
  const double least = resolution(surfaces, start.scale);
  Pairing pairing(surfaces, density);
  const Eigen::Matrix3d axes = principal_frame(select(object.points, object.samples.few)).axes;
  const auto way_of = [](const Constraint& edge) -> const Eigen::Vector3d& {
    return edge.direction;
  };
  for (int i = 0; i < iterations; ++i) {
    const Constraints forth = pairing.object_to_reference(start);
    const Constraints back = pairing.reference_to_object(start);
    const Constraints edges = pairing.edge_to_edge(start);
    Equations equations(centre);
    const double deviation = deviation_of(forth, least);
    equations.add(forth, deviation);
    equations.add(back, deviation_of(back, least));
    for (const Constraints& facing : by_facing(edges, axes, way_of))
      equations.add(facing, deviation_of(facing, kRimDeviation * object.spacing));
    equations.add_prior(scale, start.scale);
    const Vector7d step = equations.solve();
    start = moved(start, centre, step);
    const double motion =
        step.head<3>().norm() + step.segment<3>(3).norm() / object.size + std::abs(step[6]);
    if (motion < std::max(converged, kConverged * deviation / object.size)) break;
  }
  return start;
}

namespace {

/// The two rigid motions of a pose that the object's points resist least.
std::array<Vector7d, 2> weakest_motions(const SurfacePair& surfaces, const Similarity& similarity,
                                        const Eigen::Vector3d& centre) {
  const Constraints forth = Pairing(surfaces, Density::kMany).object_to_reference(similarity);
  Equations equations(centre);
  equations.add(forth, deviation_of(forth, resolution(surfaces, similarity.scale)));
  return equations.weakest(surfaces.object.size);
}

}  // namespace

std::vector<Similarity> slides(const SurfacePair& surfaces, const Similarity& similarity,
                               double step) {
  const Eigen::Vector3d centre = surfaces.object.centroid;
  std::vector<Similarity> result;
  for (const Vector7d& motion : weakest_motions(surfaces, similarity, centre)) {
    result.push_back(moved(similarity, centre, step * motion));
    result.push_back(moved(similarity, centre, -step * motion));
  }
  return result;
}

std::vector<Axis> freest_axes(const SurfacePair& surfaces, const Similarity& similarity) {
  constexpr double kTurns = 0.7;  // of a unit motion: mostly a rotation, not a shift
  const Surface& object = surfaces.object;
  const Eigen::Vector3d centre = object.centroid;
  std::vector<Axis> axes;
  for (const Vector7d& motion : weakest_motions(surfaces, similarity, centre)) {
    const Eigen::Vector3d turn = motion.head<3>();
    if (turn.norm() * object.size < kTurns) continue;
    const Eigen::Vector3d shift = motion.segment<3>(3);
    axes.push_back({centre + turn.cross(shift) / turn.squaredNorm(), turn.normalized()});
  }
  return axes;
}

}  // namespace tool_path_stretcher
