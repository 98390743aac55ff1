// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_check/attempts.h"

#include <cmath>

#include "tool_check/begin.h"
#include "tool_check/spin/spin.h"

namespace c4g_driver {
namespace {

/// Position of the first fault, in waypoints from the beginning.
double got_to(const ToolCheck& check) {
  const ToolFault& fault = check.faults.front();
  return static_cast<double>(fault.waypoint) + fault.way;
}

/// Keeps the check that passes, or else the one that gets farthest.
void keep(std::optional<ToolCheck>& best, ToolCheck&& check) {
  if (!best || check.possible() || got_to(check) > got_to(*best)) best = std::move(check);
}

ToolCheck follow(const ToolCheckSubject& subject, const Joints& begin, bool stands_there) {
  Track followed = track(subject.robot, subject.motion, begin);
  if (!stands_there) choose_turns(followed, subject);
  ToolCheck check = judge(followed, subject);
  check.stands_there = stands_there;
  return check;
}

struct Spacing {
  double length;  // [m]
  double angle;   // [rad]
};

constexpr Spacing kCoarse = {0.02, 0.17};  // chosen
constexpr Spacing kFine = {0.005, 0.05};   // used if places between coarse nodes fail; chosen

/// @param turn [rad] at the start, of the first waypoint's own pose
std::optional<ToolCheck> follow_spun(const ToolCheckSubject& subject, double turn,
                                     const Joints& begin, bool stands_there,
                                     const Spacing& spacing) {
  const SpinPath path = spin_path(subject, turn);
  const std::vector<SpinNode> nodes = spin_nodes(path, spacing.length, spacing.angle);
  const SpinArm arm(subject);
  auto spin = search_spin(arm, nodes, begin, stands_there);
  if (!spin) return std::nullopt;
  refine_spin(arm, nodes, stands_there, *spin);
  ToolMotion motion = subject.motion;
  const std::vector<Eigen::Isometry3d> tips = spun_tips(path, nodes, spin->turns);
  for (std::size_t i = 0; i < tips.size(); ++i)
    motion.waypoints[i].tip = tips[i];
  const ToolCheckSubject turned = {subject.robot, subject.limits,     subject.speed,
                                   motion,        subject.parameters, subject.scene};
  return follow(turned, spin->joints.front(), stands_there);
}

struct Begin {
  double turn = 0;  // [rad] of the first waypoint's own pose
  std::vector<Joints> postures;
  bool stands_there = false;
};

/// A start where the robot does not stand: the first turn that it can reach.
Begin begin_elsewhere(const ToolCheckSubject& subject, const RobotState& from) {
  for (const double quarters : {0, 2, 1, 3}) {
    const double turn = quarters * M_PI / 2;
    std::vector<Joints> postures = begins(subject, from, turn);
    if (!postures.empty()) return {turn, std::move(postures), false};
  }
  return {};
}

std::optional<ToolCheck> possible_spin(const ToolCheckSubject& subject, const Begin& begin) {
  for (const Joints& posture : begin.postures) {
    for (const Spacing& spacing : {kCoarse, kFine}) {
      auto check = follow_spun(subject, begin.turn, posture, begin.stands_there, spacing);
      if (!check) break;
      if (check->possible()) return check;
    }
  }
  return std::nullopt;
}

}  // namespace

ToolCheck check_as_given(const ToolCheckSubject& subject, const RobotState& from) {
  std::optional<ToolCheck> standing;
  if (stands_at_begin(subject, from)) standing = follow(subject, from.joints, true);
  if (standing && standing->possible()) return std::move(*standing);
  std::vector<Joints> postures = begins(subject, from, 0);
  if (const std::size_t within = count_within(subject, postures)) postures.resize(within);
  if (postures.empty()) postures.push_back(from.joints);
  std::optional<ToolCheck> best;
  for (const Joints& posture : postures) {
    keep(best, follow(subject, posture, false));
    if (!best->possible()) continue;
    if (standing) best->as_it_stands = standing->refusal();
    return std::move(*best);
  }
  return std::move(standing ? *standing : *best);
}

std::optional<ToolCheck> check_with_free_turn(const ToolCheckSubject& subject,
                                              const RobotState& from) {
  if (const auto turn = turn_at_begin(subject, from)) {
    if (auto check = possible_spin(subject, {*turn, {from.joints}, true})) return check;
  }
  return possible_spin(subject, begin_elsewhere(subject, from));
}

}  // namespace c4g_driver
