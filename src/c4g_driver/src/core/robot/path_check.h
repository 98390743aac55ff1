// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "c4g_driver/limits.h"
#include "c4g_driver/robot_model.h"
#include "robot/paths/path.h"

namespace c4g_driver {

/// What stands in the way of a motion, as a refusal says it.
struct Hindrance {
  std::string thing;
  std::string value;
  std::string cure;
  double way = 0;  // of the motion
};

/// The most that a motion asks of a joint's speed.
struct Strain {
  double share = 0;  // of the joint's own speed, at full override
  int joint = 0;
  double rate = 0;  // [rad/s]
  double way = 0;
};

struct PathCheck {
  std::optional<Hindrance> hindrance;  // the first one
  Strain strain;                       // up to there
  Joints joints = Joints::Zero();      // [rad] at the end, where nothing hinders
};

/// Follows the path in small steps with the posture that the robot is in: ranges of the joints,
/// box, singular postures, axes that turn over.
/// @param limits of which it takes ranges and box
/// @param joints [rad] of the robot at the path's beginning
/// @param seconds that the path takes at full override
PathCheck follow(const RobotModel& robot, const RobotLimits& limits, const Path& path,
                 const Joints& joints, double seconds);

/// The joints that a singular posture ties together, such as "J4 and J6"; empty: it is none.
std::string singular_joints(const RobotModel::Jacobian& jacobian);

/// [rad] that no joint changes by in a step of follow(), unless an axis turns over.
/// The emulator, which looks every two degrees, refuses 0.35; below half of that, since its steps
/// are not ours.
constexpr double kTurnsOver = 0.15;  // for a step of a degree

/// Into which follow() cuts a stretch: of a few millimetres and a degree at most.
double steps_along(const Path::Stretch& stretch);

/// @param slack [m] that the place may be off
/// @param way 0 .. 1 of the motion
std::optional<Hindrance> outside_workspace(const Eigen::Vector3d& place, const RobotLimits& limits,
                                           double slack, double way);

/// "35 % of the way"
std::string at(double way);

/// "-1.4 .. 1.4 m"
/// @param unit with a blank before it
std::string range(double lower, double upper, const char* unit);

}  // namespace c4g_driver
