// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/jog.h"

#include <fmt/format.h>

#include <cmath>

namespace c4g_driver {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kLength = 0.5;     // [m] of one motion; chosen
constexpr double kTurn = M_PI / 2;  // [rad] of one motion; chosen

void check(const Jog& jog) {
  if (jog.axis < 0 || jog.axis > 5)
    throw scan_cell_common::Refused("axis", fmt::format("{}", jog.axis), "give 0 to 5");
  if (jog.direction != 1 && jog.direction != -1)
    throw scan_cell_common::Refused("direction", fmt::format("{}", jog.direction), "give 1 or -1");
}

}  // namespace

Motion jog_motion(const RobotState& from, const Jog& jog, double share) {
  check(jog);
  Motion motion;
  if (jog.kind == Jog::Kind::kJoint) {
    motion.kind = Motion::Kind::kToJoints;
    motion.joints.assign(from.joints.begin(), from.joints.end());
    motion.joints[static_cast<std::size_t>(jog.axis)] += jog.direction * share * kTurn;
    return motion;
  }
  const Vector3d axis = jog.direction * Vector3d::Unit(jog.axis % 3);
  const bool turns = jog.axis > 2;
  const Vector3d way = turns ? Vector3d(Vector3d::Zero()) : Vector3d(share * kLength * axis);
  const Eigen::AngleAxisd turn(turns ? share * kTurn : 0, axis);
  motion.kind = Motion::Kind::kToPose;
  if (jog.kind == Jog::Kind::kFlange) {
    motion.flange = from.flange * Eigen::Translation3d(way) * turn;
  } else {
    motion.flange.translation() = from.flange.translation() + way;
    motion.flange.linear() = turn.toRotationMatrix() * from.flange.linear();
  }
  return motion;
}

}  // namespace c4g_driver
