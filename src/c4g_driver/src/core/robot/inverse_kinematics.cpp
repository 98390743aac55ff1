// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/inverse_kinematics.h"

#include <algorithm>
#include <cmath>
#include <kdl/chainiksolverpos_lma.hpp>
#include <limits>

namespace c4g_driver {
namespace {

/// The i-th number of van der Corput's sequence, spread over 0 .. 1; Halton (1960) uses one with a
/// different prime for each dimension.
double spread(unsigned i, unsigned prime) {
  double result = 0;
  for (double digit = 1.0 / prime; i > 0; i /= prime, digit /= prime)
    result += digit * (i % prime);
  return result;
}

Joints start_of(unsigned i, const RobotModel& robot) {
  constexpr std::array<unsigned, 6> kPrimes = {2, 3, 5, 7, 11, 13};
  Joints joints;
  for (int k = 0; k < 6; ++k) {
    const double least = std::max(robot.lower()[k], -M_PI);
    const double most = std::min(robot.upper()[k], M_PI);
    joints[k] = least + (most - least) * spread(i, kPrimes[static_cast<std::size_t>(k)]);
  }
  return joints;
}

/// Shifts each joint by full turns, as near to `near` as its range allows.
Joints turned_near(Joints joints, const RobotModel& robot, const Joints& near) {
  constexpr double kTurn = 2 * M_PI;
  for (int k = 0; k < 6; ++k) {
    double best = joints[k] + kTurn * std::round((near[k] - joints[k]) / kTurn);
    while (best > robot.upper()[k] && best - kTurn >= robot.lower()[k])
      best -= kTurn;
    while (best < robot.lower()[k] && best + kTurn <= robot.upper()[k])
      best += kTurn;
    joints[k] = best;
  }
  return joints;
}

/// KDL's Levenberg-Marquardt solver: ends near a pose, or as near as it gets.
class NearestJoints {
 public:
  explicit NearestJoints(const RobotModel& robot)
      : robot_(robot), solver_(robot.chain(), weights(), kClose, kIterations) {}

  Joints operator()(const Eigen::Isometry3d& flange, const Joints& start) {
    KDL::JntArray ended(6);
    solver_.CartToJnt(to_kdl(start), to_kdl(flange), ended);
    return ended.data;
  }

  double gap(const Joints& joints, const Eigen::Isometry3d& flange) const {
    return twist(robot_.flange_at(joints), flange).head<3>().norm();
  }

 private:
  static constexpr double kClose = 1e-5;  // KDL treats smaller rotations as zero: step_to refines
  static constexpr int kIterations = 60;  // chosen

  static Joints weights() { return (Joints() << 1, 1, 1, 0.1, 0.1, 0.1).finished(); }

  const RobotModel& robot_;
  KDL::ChainIkSolverPos_LMA solver_;
};

}  // namespace

std::optional<Joints> step_to(const RobotModel& robot, const Eigen::Isometry3d& flange,
                              const Joints& near) {
  constexpr double kPrecision = 1e-9;  // [m] and [rad]; chosen
  constexpr double kMaxStep = 0.3;     // [rad] chosen
  constexpr int kSteps = 15;           // chosen
  Joints joints = near;
  for (int step = 0; step < kSteps && joints.allFinite(); ++step) {
    const Joints error = twist(robot.flange_at(joints), flange);
    if (error.head<3>().norm() < kPrecision && error.tail<3>().norm() < kPrecision) return joints;
    const Joints change = robot.jacobian_at(joints).partialPivLu().solve(error);
    joints += change * std::min(1.0, kMaxStep / change.cwiseAbs().maxCoeff());
  }
  return std::nullopt;
}

Postures postures_for(const RobotModel& robot, const Eigen::Isometry3d& flange,
                      const Joints& near) {
  constexpr unsigned kStarts = 48;
  constexpr double kSame = 1e-4;  // [rad] chosen
  NearestJoints nearest(robot);
  Postures found;
  found.gap = std::numeric_limits<double>::infinity();
  for (unsigned i = 0; i <= kStarts; ++i) {
    const Joints close = nearest(flange, i == 0 ? near : start_of(i, robot));
    if (!close.allFinite()) continue;
    found.gap = std::min(found.gap, nearest.gap(close, flange));
    const auto exact = step_to(robot, flange, close);
    if (!exact) continue;
    const Joints joints = turned_near(*exact, robot, near);
    const bool known = std::any_of(
        found.joints.begin(), found.joints.end(),
        [&](const Joints& other) { return (other - joints).cwiseAbs().maxCoeff() < kSame; });
    if (!known) found.joints.push_back(joints);
  }
  if (!found.joints.empty()) found.gap = 0;
  return found;
}

double gap_from(const RobotModel& robot, const Eigen::Isometry3d& flange, Joints& joints) {
  NearestJoints nearest(robot);
  const Joints ended = nearest(flange, joints);
  if (!ended.allFinite()) return nearest.gap(joints, flange);
  joints = ended;
  return nearest.gap(joints, flange);
}

double excess(const Joints& joints, const Joints& lower, const Joints& upper) {
  return ((lower - joints).cwiseMax(0) + (joints - upper).cwiseMax(0)).sum();
}

}  // namespace c4g_driver
