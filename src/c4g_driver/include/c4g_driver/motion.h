// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "c4g_driver/limits.h"
#include "scan_cell_common/errors/errors.h"

namespace c4g_driver {

/// A motion as requested.
struct Motion {
  /// Where it goes, and how.
  enum class Kind {
    kToPose,    //!< MOVE_CARTESIAN
    kAlongArc,  //!< MOVE_CIRCULAR
    kToJoints,  //!< MOVE_JOINT
  };
  Kind kind = Kind::kToPose;                                 //!< where it goes, and how
  Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();  //!< target; not for kToJoints
  Eigen::Isometry3d via = Eigen::Isometry3d::Identity();     //!< of kAlongArc: passed on the way
  std::vector<double> joints;                                //!< of kToJoints: six [rad]
  double camera_rate = 0;                                    //!< [Hz]
};

/// How the controller carries out motions: its parameters in c4g_protocol.md.
struct MotionSettings {
  bool in_joints = false;       //!< MOVE_CARTESIAN is a joint motion
  bool euler = false;           //!< along a line, A, E and R each change at their own rate
  double linear_speed = 0.25;   //!< [m/s] along a line or an arc
  double rotational_speed = 1;  //!< [rad/s] along it; the slower of the two speeds decides
  double override = 100;        //!< [%] of all speeds
};

/// A place along a motion.
struct MotionPlace {
  double way = 0;            //!< 0 .. 1 of the motion
  Eigen::Isometry3d flange;  //!< in base_link
};

/// A motion cannot be carried out because of one place along it.
class MotionRefused : public scan_cell_common::Refused {
 public:
  /// @param thing, value, cure as of Refused
  MotionRefused(const std::string& thing, const std::string& value, const std::string& cure,
                const MotionPlace& place)
      : Refused(thing, value, cure), place_(place) {}

  const MotionPlace& place() const { return place_; }  //!< where it fails

 private:
  MotionPlace place_;
};

/// Checks what does not depend on where the robot stands: target, via and camera rate.
/// @param limits narrowed() to the robot
/// @throw scan_cell_common::Refused naming what is wrong
void check_goal(const Motion& motion, const RobotModel& robot, const RobotLimits& limits);

}  // namespace c4g_driver
