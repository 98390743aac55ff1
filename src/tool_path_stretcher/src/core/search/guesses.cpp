// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "search/guesses.h"

#include <algorithm>
#include <cmath>

#include "geometry/points.h"

namespace tool_path_stretcher {
namespace {

/// An even cover of all rotations: the super-Fibonacci spiral (Alexa 2022).
std::vector<Eigen::Matrix3d> even_rotations(int count) {
  const double phi = std::sqrt(2.0);
  constexpr double kPsi = 1.533751168755204288118041;  // solves psi^4 = psi + 4 (Alexa 2022)
  std::vector<Eigen::Matrix3d> rotations;
  for (int i = 0; i < count; ++i) {
    const double s = i + 0.5;
    const double inner = std::sqrt(s / count);
    const double outer = std::sqrt(1 - s / count);
    const double alpha = 2 * M_PI * s / phi;
    const double beta = 2 * M_PI * s / kPsi;
    rotations.push_back(Eigen::Quaterniond(outer * std::cos(beta), inner * std::sin(alpha),
                                           inner * std::cos(alpha), outer * std::sin(beta))
                            .normalized()
                            .toRotationMatrix());
  }
  return rotations;
}

std::vector<Similarity> centred(const std::vector<Eigen::Matrix3d>& rotations,
                                const CoarsePair& surfaces) {
  const PrincipalFrame& reference = surfaces.reference.frame;
  const PrincipalFrame& object = surfaces.object.frame;
  const double scale = object.deviation.norm() / reference.deviation.norm();
  std::vector<Similarity> guesses;
  for (const Eigen::Matrix3d& rotation : rotations) {
    guesses.push_back({scale, rotation, object.centroid - scale * (rotation * reference.centroid)});
  }
  return guesses;
}

}  // namespace

std::vector<Eigen::Matrix3d> cube_turns() {
  std::vector<Eigen::Matrix3d> turns;
  const std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (const auto& order : orders) {
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
      for (int axis = 0; axis < 3; ++axis)
        turn(order[static_cast<std::size_t>(axis)], axis) = (signs >> axis) & 1 ? -1 : 1;
      if (turn.determinant() > 0) turns.push_back(turn);
    }
  }
  return turns;
}

std::vector<Similarity> principal_guesses(const CoarsePair& surfaces) {
  std::vector<Eigen::Matrix3d> rotations;
  for (const Eigen::Matrix3d& turn : cube_turns())
    rotations.push_back(surfaces.object.frame.axes * turn *
                        surfaces.reference.frame.axes.transpose());
  return centred(rotations, surfaces);
}

std::vector<Similarity> even_guesses(const CoarsePair& surfaces) {
  constexpr int kVerticalSteps = 24;   // of 15 degrees; chosen
  constexpr int kEvenRotations = 144;  // chosen
  std::vector<Eigen::Matrix3d> rotations = even_rotations(kEvenRotations);
  for (int i = 0; i < kVerticalSteps; ++i) {
    rotations.push_back(Eigen::AngleAxisd(2 * M_PI * i / kVerticalSteps, Eigen::Vector3d::UnitZ())
                            .toRotationMatrix());
  }
  return centred(rotations, surfaces);
}

Similarity clamped(const Similarity& guess, const ScaleRange& scales,
                   const Eigen::Vector3d& middle) {
  Similarity result = guess;
  result.scale = std::clamp(guess.scale, scales.least, scales.most);
  result.translation = guess * middle - result.scale * (guess.rotation * middle);
  return result;
}

std::vector<Similarity> guesses_about(const Prior& prior, const CoarsePair& surfaces) {
  const PrincipalFrame& reference = surfaces.reference.frame;
  const PrincipalFrame& object = surfaces.object.frame;
  const double ratio = object.deviation.norm() / reference.deviation.norm();
  const double scale = prior.scale.is_known() ? prior.scale.value : ratio;
  const Similarity given{scale, prior.pose->pose.linear(), prior.pose->pose.translation()};
  std::vector<Eigen::Matrix3d> rotations = {given.rotation};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double share : {-0.7, 0.7}) {  // of the angle; chosen
      const Eigen::AngleAxisd turn(share * prior.pose->angle, Eigen::Vector3d::Unit(axis));
      rotations.push_back(turn * given.rotation);
    }
  }
  std::vector<Similarity> guesses;
  for (const Eigen::Matrix3d& rotation : rotations) {
    for (const Eigen::Vector3d& middle : {given * reference.centroid, object.centroid})
      guesses.push_back({scale, rotation, middle - scale * (rotation * reference.centroid)});
  }
  return guesses;
}

std::vector<Similarity> turned_in_itself(const PrincipalFrame& frame, const Similarity& pose) {
  constexpr int kSteps = 24;           // of 15 degrees; chosen
  constexpr int kEvenRotations = 400;  // chosen
  std::vector<Eigen::Matrix3d> turns = cube_turns();
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::AngleAxisd over(M_PI, Eigen::Vector3d::Unit((axis + 1) % 3));
    for (int i = 0; i < kSteps; ++i) {
      const Eigen::AngleAxisd turn(2 * M_PI * i / kSteps, Eigen::Vector3d::Unit(axis));
      if (i > 0) turns.push_back(turn.toRotationMatrix());
      turns.push_back((turn * over).toRotationMatrix());
    }
  }
  for (const Eigen::Matrix3d& turn : even_rotations(kEvenRotations))
    turns.push_back(turn);
  const Eigen::Vector3d centre = pose * frame.centroid;
  std::vector<Similarity> turned;
  for (const Eigen::Matrix3d& turn : turns) {
    Similarity guess = pose;
    guess.rotation = pose.rotation * frame.axes * turn * frame.axes.transpose();
    guess.translation = centre - guess.scale * (guess.rotation * frame.centroid);
    turned.push_back(guess);
  }
  return turned;
}

}  // namespace tool_path_stretcher
