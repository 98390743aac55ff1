// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tool_path_programs {

/// A frame as a robot program refers to it.
struct Frame {
  std::string name;                       //!< as the language writes it; empty: it has none
  std::optional<Eigen::Isometry3d> pose;  //!< [m] none: not given in the program
};

/// The frames of a move: its pose is that of the tool frame in the user frame.
struct Frames {
  Frame tool;  //!< the tool's tip on the flange
  Frame user;  //!< the frame that poses are given in, in the robot's base
};

/// How the tool moves to a pose.
enum class MotionKind {
  kJoint,     //!< all axes together
  kLinear,    //!< the tip along a line, the tool about one fixed axis
  kCircular,  //!< the tip along the arc through `via`
};

/// Joint angles of the robot at a pose.
using JointAngles = std::array<double, 6>;

/// A motion to a pose of the tool's tip.
struct Move {
  MotionKind kind = MotionKind::kLinear;                   //!< kind of motion
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  //!< tip in the user frame [m]
  std::optional<Eigen::Isometry3d> via;                    //!< of kCircular [m]
  double speed = 0.05;                                     //!< [m/s] of the tip; not for kJoint
  double joint_speed = 0.1;                                //!< of kJoint: share of the axes' speed
  double zone = 0;         //!< [m] how far from the pose the tip may leave its way; 0: it stops
  std::size_t frames = 0;  //!< index in Program::frames
  /// Waypoint of the tool path that the program was made from, over all segments; none: another
  /// pose
  std::optional<std::size_t> waypoint;
  /// [rad] with the controller's signs, if known; for languages that write configurations
  std::optional<JointAngles> joints;
};

/// A motion to joint angles instead of a pose. It is never adapted.
struct JointMove {
  std::vector<double> joints;  //!< as written, in the language's own unit
};

/// Switches a digital output, in the order of the motion.
struct SetOutput {
  std::string output;  //!< as the language names it: 5, doTool
  bool on = false;     //!< the new state
};

/// A statement of a program that matters to a tool path.
using Step = std::variant<Move, JointMove, SetOutput>;

/// A robot program in any language.
struct Program {
  std::string name;                   //!< of the main routine
  std::vector<std::string> comments;  //!< lines above everything else
  std::vector<Frames> frames;         //!< that its moves use
  std::vector<Step> steps;            //!< in the order of the motion
};

/// The moves to poses among the steps, in order.
std::vector<const Move*> moves_of(const Program& program);

/// @throw scan_cell_common::UnusableInput naming the first move that has a value that is not
/// finite, an invalid rotation, a speed not above 0, a negative zone, or is circular without a via;
/// or if the program has no move
void check(const Program& program);

}  // namespace tool_path_programs
