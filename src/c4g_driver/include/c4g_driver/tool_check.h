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

/// How a path of the tool is checked, beside the limits of every motion.
struct ToolCheckParameters {
  double joint_margin = 0.02;   //!< [rad] that each joint keeps from the ends of its range
  double rotational_speed = 1;  //!< [rad/s] of the tool, where it turns more than it moves
  bool free_about_z = false;    //!< the tool may turn about its z as the robot likes it
};

/// With range, unit and meaning of each.
void describe(scan_cell_common::ParameterTable& table, ToolCheckParameters& parameters);

/// Why a path cannot be followed at one of its places. what() is for a person.
struct ToolFault {
  /// What is wrong.
  enum class Kind {
    kHalfTurn,    //!< the tool turns by half a turn: which way round is open
    kToolSpeed,   //!< faster than the tool or the flange may go
    kReach,       //!< too far away
    kPosture,     //!< only in another posture of the robot
    kSingular,    //!< a singular posture
    kTurnsOver,   //!< a joint jumps
    kWorkspace,   //!< the flange leaves its box
    kJointRange,  //!< a joint comes too near to an end of its range
    kCollision,   //!< the robot or its tool runs into something
    kJointSpeed,  //!< a joint has to go too fast
  };
  Kind kind = Kind::kReach;  //!< what is wrong
  std::size_t waypoint = 0;  //!< counted from 0: at it, or on the way to it
  double way = 1;            //!< 0 .. 1 of the way from the waypoint before; 1: at the waypoint
  Eigen::Isometry3d tip = Eigen::Isometry3d::Identity();  //!< there, in base_link
  std::optional<int> joint;                               //!< 0 .. 5, if it is about one
  std::string about;  //!< beside the place, such as "J5" or "z of the flange"; may be empty
  std::string thing;  //!< such as "waypoint 12, J5"
  std::string value;  //!< the figure
  std::string cure;   //!< what to do

  std::string what() const { return thing + ": " + value + "; " + cure; }  //!< for a person
};

/// "joint_range"
const char* to_string(ToolFault::Kind kind);

/// Where the tip has to go slowest.
struct SlowestPlace {
  std::size_t waypoint = 0;  //!< on the way to it, or at it
  double way = 1;            //!< 0 .. 1 of that way
  double speed = 0;          //!< [m/s] of the tip, the most that all joints can do there
  double wanted = 0;         //!< [m/s] that the path asks for there
  int joint = 0;             //!< 0 .. 5, whose speed decides; 6: the tool's own, rotational_speed
};

/// The least distance of a joint from the ends of its range.
struct JointMargin {
  double margin = 0;         //!< [rad] negative: outside
  std::size_t waypoint = 0;  //!< at it, or on the way to it
};

/// What a check of a whole path found.
struct ToolCheck {
  std::vector<ToolFault> faults;  //!< along the path; of each kind and joint the worst between two
                                  //!< waypoints; empty: the path can be followed
  std::vector<Joints> joints;     //!< [rad] at each waypoint; NaN where the robot does not get
  std::vector<Eigen::Isometry3d> tips;  //!< at each waypoint, in base_link, as followed
  std::optional<SlowestPlace> slowest;  //!< none: the tip moves nowhere
  std::array<JointMargin, 6> margins;   //!< of each joint, along the whole path
  bool stands_there = false;            //!< the robot stands at the first waypoint, in its posture

  std::string as_it_stands;  //!< why the posture in which it stands there cannot follow, where
                             //!< another one can; else empty

  bool possible() const { return faults.empty(); }  //!< whether the robot can follow the path
  std::string refusal() const;                      //!< the first fault, for a person; or empty
};

}  // namespace c4g_driver
