// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/slack.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "geometry/robust.h"

namespace tool_path_stretcher {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;

Matrix6d beyond_noise(const Matrix6d& steadily, const Matrix6d& noise) {
  constexpr double kShared = 4;  // neighbouring normals share points, so tilts do not average out
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(steadily - kShared * noise);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() *
         solver.eigenvectors().transpose();
}

}  // namespace

Motions rigid_motions(const Eigen::Vector3d& point, const Turns& turns) {
  Motions motions;
  for (int axis = 0; axis < 3; ++axis) {
    motions.col(axis) = Eigen::Vector3d::Unit(axis).cross(point - turns.centre) / turns.size;
    motions.col(3 + axis) = Eigen::Vector3d::Unit(axis);
  }
  return motions;
}

Held held_by(const std::vector<GraphConstraint>& constraints, const std::vector<double>& off,
             double weight, const Turns& turns) {
  constexpr double kSteady = 3;  // times the median; chosen
  Held held;
  const double most = kSteady * quantile(off, 0.5);
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const Motions motions = rigid_motions(constraints[i].target, turns);
    const Vector6d along = motions.transpose() * constraints[i].direction;
    const Matrix6d one = weight * along * along.transpose();
    held.all += one;
    if (off[i] > most) continue;
    held.steadily += one;
    held.noise += std::pow(off[i], 2) * (weight * motions.transpose() * motions - one);
  }
  return held;
}

Matrix6d seemingly_held(const Held& normals, const Held& rims, bool edges_are_known,
                        const Turns& turns, const PoseDeviation& pose) {
  const Matrix6d really =
      edges_are_known ? Matrix6d(beyond_noise(normals.steadily, normals.noise) +
                                 beyond_noise(rims.steadily, rims.noise))
                      : beyond_noise(normals.steadily + rims.steadily, normals.noise + rims.noise);
  Vector6d known;  // [m] prior deviations of the motions
  known << Eigen::Vector3d::Constant(pose.angle * turns.size),
      Eigen::Vector3d::Constant(pose.distance);
  const Matrix6d prior = known.cwiseAbs2().cwiseInverse().asDiagonal();
  return Matrix6d((really + prior).inverse() - (normals.all + rims.all + prior).inverse());
}

}  // namespace tool_path_stretcher
