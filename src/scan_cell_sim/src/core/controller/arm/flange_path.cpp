// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/arm/flange_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scan_cell_sim {
namespace {

/// Whether the arm is in a singular posture, or has passed one since `before`.
bool singular(const Joints& before, const Joints& joints) {
  constexpr double kAngle = 0.5 * M_PI / 180;  // [rad] c4g_protocol.md
  constexpr double kDistance = 0.005;          // [m] c4g_protocol.md
  const SingularPostures was = distance_to_singular(before);
  const SingularPostures is = distance_to_singular(joints);
  const auto met = [](double then, double now, double least) {
    return std::abs(now) < least || (then < 0) != (now < 0);
  };
  return met(was.wrist, is.wrist, kAngle) || met(was.elbow, is.elbow, kAngle) ||
         met(was.shoulder, is.shoulder, kDistance);
}

void refuse_singular(const Joints& before, const Joints& joints, const std::string& name) {
  constexpr double kMaxTurn = 0.35;  // [rad] more from knot to knot turns the wrist over
  if (singular(before, joints)) {
    throw ControllerRefusal(ControllerErrorCode::kSingular,
                            "the " + name + " passes a singular posture");
  }
  if ((joints - before).cwiseAbs().maxCoeff() > kMaxTurn) {
    throw ControllerRefusal(ControllerErrorCode::kSingular,
                            "the " + name + " turns the wrist over");
  }
}

}  // namespace

Joints FlangePath::joints(double way) const {
  const auto after =
      std::upper_bound(knots_.begin() + 1, knots_.end() - 1, way,
                       [](double wanted, const Knot& knot) { return wanted < knot.way; });
  const auto before = after - 1;
  const double fraction = std::clamp((way - before->way) / (after->way - before->way), 0.0, 1.0);
  const Joints guess = (1 - fraction) * before->joints + fraction * after->joints;
  return joints_of(flange(way), guess).value_or(guess);
}

double FlangePath::turning() const {
  double most = 0;
  double begin = 0;
  for (const Stretch& stretch : stretches()) {
    most = std::max(most, stretch.angle / (stretch.end - begin));
    begin = stretch.end;
  }
  return most;
}

double FlangePath::follow(const Joints& from) {
  constexpr double kKnotLength = 0.01;  // [m] chosen
  constexpr double kKnotAngle = 0.035;  // [rad] chosen
  refuse_singular(from, from, name());
  knots_.assign(1, {0, from, 0});
  double max_speed = std::numeric_limits<double>::infinity();
  double begin = 0;
  for (const Stretch& stretch : stretches()) {
    const double share = stretch.end - begin;
    const double steps = std::ceil(
        std::max({1.0, share * length() / kKnotLength, stretch.turn / kKnotAngle}) - kNothing);
    for (double step = 1; step <= steps; ++step)
      max_speed = std::min(max_speed, step_to(begin + share * step / steps));
    begin = stretch.end;
  }
  return max_speed;
}

/// @return [1/s] the most that the axes allow from the previous knot
double FlangePath::step_to(double way) {
  const Knot& before = knots_.back();
  const auto next = joints_of(flange(way), before.joints);
  if (!next) {
    throw ControllerRefusal(ControllerErrorCode::kOutOfReach,
                            "the " + name() + " leaves the robot's reach");
  }
  refuse_singular(before.joints, *next, name());
  const std::string outside = outside_limits(*next);
  if (!outside.empty()) {
    throw ControllerRefusal(ControllerErrorCode::kJointLimit, "on the " + name() + " " + outside);
  }
  const Joints turn = (*next - before.joints).cwiseAbs() / (way - before.way);
  const double most = 1 / std::max(turn.cwiseQuotient(joint_limits().speed).maxCoeff(), kNothing);
  knots_.push_back({way, *next, most});
  return most;
}

}  // namespace scan_cell_sim
