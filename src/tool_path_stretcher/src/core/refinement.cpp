// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <cmath>

#include "robust.h"
#include "tool_path_stretcher/alignment.h"
#include "tool_path_stretcher/residuals.h"

namespace tool_path_stretcher {
namespace {

using Vector7d = Eigen::Matrix<double, 7, 1>;
using Matrix7d = Eigen::Matrix<double, 7, 7>;

constexpr double kReach = 3;  // spacings beside a surface, beyond which a point is none of it

/// A point of the mapped reference that should move by `error` along `direction`, in the object's
/// frame.
struct Constraint {
  Eigen::Vector3d point;
  Eigen::Vector3d direction;  // unit length
  double error;               // [m]
};

/// What one direction of the comparison asks for.
struct Constraints {
  std::vector<Constraint> along_normal;
  std::vector<Constraint> beside;  // object points past the rim of the reference, or the reverse
};

/// Splits the way from a mapped reference point to an object point into both kinds.
void add(const Eigen::Vector3d& mapped, const Eigen::Vector3d& object,
         const Eigen::Vector3d& normal, double spacing, double reach, Constraints& constraints) {
  const Eigen::Vector3d way = object - mapped;
  const double along = normal.dot(way);
  const Eigen::Vector3d tangential = way - along * normal;
  const double beside = tangential.norm() - spacing;
  if (beside < reach) constraints.along_normal.push_back({mapped, normal, along});
  if (beside > 0 && beside < reach) {
    constraints.beside.push_back({mapped, tangential.normalized(), beside});
  }
}

Constraints object_to_reference(const Surface& reference, const Points& object_points,
                                const Similarity& similarity) {
  Constraints constraints;
  const double spacing = similarity.scale * reference.spacing;
  for (const Eigen::Vector3d& point : object_points) {
    const auto nearest = reference.tree->nearest(similarity.inverse(point));
    add(similarity * reference.points[nearest.index], point,
        similarity.rotation * reference.normals[nearest.index], spacing, kReach * spacing,
        constraints);
  }
  return constraints;
}

Constraints reference_to_object(const Surface& object, const Points& reference_points,
                                const Similarity& similarity) {
  Constraints constraints;
  for (const Eigen::Vector3d& point : reference_points) {
    const Eigen::Vector3d mapped = similarity * point;
    const auto nearest = object.tree->nearest(mapped);
    add(mapped, object.points[nearest.index], object.normals[nearest.index], object.spacing,
        kReach * object.spacing, constraints);
  }
  return constraints;
}

/// Normal equations of a small similarity about `centre`: turn, shift, relative growth.
class Equations {
 public:
  explicit Equations(const Eigen::Vector3d& centre) : centre_(centre) {}

  /// All constraints together weigh `share`, however many they are.
  void add(const std::vector<Constraint>& constraints, double cut, double share) {
    if (constraints.empty()) return;
    const double each = share / static_cast<double>(constraints.size());
    for (const Constraint& constraint : constraints) {
      const double weight = each * tukey_weight(constraint.error, cut);
      if (weight == 0) continue;
      const Eigen::Vector3d arm = constraint.point - centre_;
      Vector7d row;
      row << arm.cross(constraint.direction), constraint.direction, arm.dot(constraint.direction);
      matrix_ += weight * row * row.transpose();
      right_side_ += weight * constraint.error * row;
    }
  }

  Vector7d solve(ScaleMode mode) const {
    constexpr double kDamping = 1e-9;  // pins what the surfaces do not show
    Matrix7d matrix = matrix_;
    for (int i = 0; i < 7; ++i)
      matrix(i, i) += kDamping * matrix_(i, i) + 1e-15;
    Vector7d step = Vector7d::Zero();
    if (mode == ScaleMode::kFixed) {
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
};

Similarity moved(const Similarity& similarity, const Eigen::Vector3d& centre,
                 const Vector7d& step) {
  const double angle = step.head<3>().norm();
  const Eigen::Matrix3d turn =
      angle > 0 ? Eigen::AngleAxisd(angle, step.head<3>() / angle).toRotationMatrix()
                : Eigen::Matrix3d::Identity();
  constexpr double kMostGrowth = 0.1;  // a step
  const double growth = std::exp(std::clamp(step[6], -kMostGrowth, kMostGrowth));
  Similarity result;
  result.scale = growth * similarity.scale;
  result.rotation = Eigen::Quaterniond(turn * similarity.rotation).normalized().toRotationMatrix();
  result.translation =
      growth * (turn * (similarity.translation - centre)) + centre + step.segment<3>(3);
  return result;
}

double cut_of(const std::vector<Constraint>& constraints, double least) {
  std::vector<double> errors;
  for (const Constraint& constraint : constraints)
    errors.push_back(constraint.error);
  return std::max(kTukeyCut * robust_deviation(std::move(errors)), least);
}

}  // namespace

Similarity refine(const Surface& reference, const Surface& object, Similarity start, ScaleMode mode,
                  std::size_t most_points, int iterations) {
  constexpr double kWhole = 0.95;  // share of the reference covered, from which its rim counts too
  constexpr double kBesideShare = 0.1;  // weight of the rims
  constexpr double kConverged = 1e-8;
  const Points object_points = select(object.points, spread_evenly(object.points, most_points));
  const Points reference_points =
      select(reference.points, spread_evenly(reference.points, most_points));
  const Eigen::Vector3d centre = principal_frame(object_points).centroid;
  const double least_cut = 1e-6 * object.size;
  for (int i = 0; i < iterations; ++i) {
    const Constraints forth = object_to_reference(reference, object_points, start);
    const Constraints back = reference_to_object(object, reference_points, start);
    Equations equations(centre);
    equations.add(forth.along_normal, cut_of(forth.along_normal, least_cut), 1);
    equations.add(back.along_normal, cut_of(back.along_normal, least_cut), 1);
    const auto rim_share = [](const Constraints& constraints, std::size_t points) {
      return kBesideShare * static_cast<double>(constraints.beside.size()) /
             static_cast<double>(points);
    };
    equations.add(forth.beside, kReach * object.spacing, rim_share(forth, object_points.size()));
    if (static_cast<double>(back.along_normal.size()) >
        kWhole * static_cast<double>(reference_points.size())) {
      equations.add(back.beside, kReach * object.spacing, rim_share(back, reference_points.size()));
    }
    const Vector7d step = equations.solve(mode);
    start = moved(start, centre, step);
    const double motion =
        step.head<3>().norm() + step.segment<3>(3).norm() / object.size + std::abs(step[6]);
    if (motion < kConverged) break;
  }
  return start;
}

}  // namespace tool_path_stretcher
