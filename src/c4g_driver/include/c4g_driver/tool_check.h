// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "c4g_driver/robot_state.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace c4g_driver {

/// Parameters of the check of a tool path, in addition to the limits of every motion.
struct ToolCheckParameters {
  double joint_margin = 0.02;   //!< [rad] least distance of each joint from the ends of its range
  double rotational_speed = 1;  //!< [rad/s] of the tool, where it turns more than it moves
  bool free_about_z = false;    //!< the robot may choose the tool's turn about its z
};

/// Adds each parameter with its range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, ToolCheckParameters& parameters);

/// Why a path cannot be followed at one place. what() is a message for a person.
struct ToolFault {
  /// What is wrong.
  enum class Kind {
    kHalfTurn,    //!< the tool turns by half a turn: the direction is undefined
    kToolSpeed,   //!< faster than the tool or the flange may move
    kReach,       //!< too far away
    kPosture,     //!< only in another posture of the robot
    kSingular,    //!< a singular posture
    kTurnsOver,   //!< a joint jumps
    kWorkspace,   //!< the flange leaves its box
    kJointRange,  //!< a joint comes too close to an end of its range
    kCollision,   //!< the robot or its tool collides
    kJointSpeed,  //!< a joint has to move too fast
  };
  Kind kind = Kind::kReach;  //!< what is wrong
  std::size_t waypoint = 0;  //!< counted from 0; the fault is at it or on the way to it
  double way = 1;            //!< 0 .. 1 of the way from the waypoint before; 1: at the waypoint
  Eigen::Isometry3d tip = Eigen::Isometry3d::Identity();  //!< at that place, in base_link
  std::optional<int> joint;                               //!< 0 .. 5, if the fault concerns one
  std::string about;  //!< without the place, such as "J5" or "z of the flange"; may be empty
  std::string thing;  //!< such as "waypoint 12, J5"
  std::string value;  //!< the figure
  std::string cure;   //!< what to do

  std::string what() const { return thing + ": " + value + "; " + cure; }  //!< for a person
};

/// "joint_range"
const char* to_string(ToolFault::Kind kind);

/// Where the tip has to move slowest.
struct SlowestPlace {
  std::size_t waypoint = 0;  //!< the place is on the way to it, or at it
  double way = 1;            //!< 0 .. 1 of that way
  double speed = 0;          //!< [m/s] of the tip: the most that the joints allow there
  double wanted = 0;         //!< [m/s] that the path asks for there
  int joint = 0;             //!< 0 .. 5: the joint that limits it; 6: rotational_speed of the tool
};

/// The least distance of a joint from the ends of its range.
struct JointMargin {
  double margin = 0;         //!< [rad] negative: outside
  std::size_t waypoint = 0;  //!< the place is at it or on the way to it
};

/// Result of the check of a whole path.
struct ToolCheck {
  std::vector<ToolFault> faults;  //!< in path order; the worst of each kind and joint between two
                                  //!< waypoints; empty: the path can be followed
  std::vector<Joints> joints;     //!< [rad] at each waypoint; NaN where the robot cannot get
  std::vector<Eigen::Isometry3d> tips;  //!< at each waypoint, in base_link, as followed
  std::optional<SlowestPlace> slowest;  //!< none: the tip does not move
  std::array<JointMargin, 6> margins;   //!< of each joint, along the whole path
  bool stands_there = false;            //!< the robot stands at the first waypoint, in its posture

  std::string as_it_stands;  //!< why the posture in which the robot stands there cannot follow the
                             //!< path if another one can; else empty

  bool possible() const { return faults.empty(); }  //!< whether the robot can follow the path
  std::string refusal() const;                      //!< the first fault, for a person; or empty
};

}  // namespace c4g_driver
