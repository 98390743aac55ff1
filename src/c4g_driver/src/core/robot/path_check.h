// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "c4g_driver/limits.h"
#include "c4g_driver/robot_model.h"
#include "robot/paths/path.h"

namespace c4g_driver {

/// What prevents a motion, in the words of a refusal.
struct Hindrance {
  std::string thing;
  std::string value;
  std::string cure;
  double way = 0;  // of the motion
};

/// The highest joint speed that a motion demands.
struct Strain {
  double share = 0;  // of the joint's own speed, at full override
  int joint = 0;
  double rate = 0;  // [rad/s]
  double way = 0;
};

struct PathCheck {
  std::optional<Hindrance> hindrance;  // the first one
  Strain strain;                       // up to the hindrance
  Joints joints = Joints::Zero();      // [rad] at the end, if there is no hindrance
};

/// Follows the path in small steps in the robot's present posture, and checks joint ranges, box,
/// singular postures and axes that turn over.
/// @param limits only ranges and box are used
/// @param joints [rad] of the robot at the start of the path
/// @param seconds that the path takes at full override
PathCheck follow(const RobotModel& robot, const RobotLimits& limits, const Path& path,
                 const Joints& joints, double seconds);

/// The joints that a singular posture couples, such as "J4 and J6"; empty: not singular.
std::string singular_joints(const RobotModel::Jacobian& jacobian);

/// [rad] A joint that changes by more in a step of follow() turns over. The emulator, which checks
/// every two degrees, refuses 0.35; this is less than half of that, since its steps are not ours.
constexpr double kTurnsOver = 0.15;  // for a step of a degree

/// Number of steps into which follow() cuts a stretch, each at most a few millimetres and a degree.
double steps_along(const Path::Stretch& stretch);

/// @param slack [m] tolerance of the place
/// @param way 0 .. 1 of the motion
std::optional<Hindrance> outside_workspace(const Eigen::Vector3d& place, const RobotLimits& limits,
                                           double slack, double way);

/// "35 % of the way"
std::string at(double way);

/// "-1.4 .. 1.4 m"
/// @param unit with a leading blank
std::string range(double lower, double upper, const char* unit);

}  // namespace c4g_driver
