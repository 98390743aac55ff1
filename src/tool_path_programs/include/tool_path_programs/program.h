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

/// A frame as a robot's program knows it.
struct Frame {
  std::string name;                       //!< as the language writes it; empty: it has none
  std::optional<Eigen::Isometry3d> pose;  //!< [m] none: the program does not say where it is
};

/// What the poses of a move are between.
struct Frames {
  Frame tool;  //!< the tool's tip on the flange
  Frame user;  //!< the frame that poses are given in, in the robot's base
};

/// How the tool goes to a pose.
enum class MotionKind {
  kJoint,     //!< all axes together
  kLinear,    //!< the tip along a line, the tool about one fixed axis
  kCircular,  //!< the tip along the arc through `via`
};

/// Where the axes of the robot are at a pose.
using JointAngles = std::array<double, 6>;

/// A motion to a pose of the tool's tip.
struct Move {
  MotionKind kind = MotionKind::kLinear;                   //!< the way there
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  //!< tip in the user frame [m]
  std::optional<Eigen::Isometry3d> via;                    //!< of kCircular, on the way [m]
  double speed = 0.05;                                     //!< [m/s] of the tip; not of kJoint
  double joint_speed = 0.1;                                //!< of kJoint: share of the axes' own
  double zone = 0;         //!< [m] how far from the pose the tip may leave its way; 0: it stops
  std::size_t frames = 0;  //!< which of Program::frames
  /// Of the tool path that the program was made from, over all segments; none: it is on the way
  std::optional<std::size_t> waypoint;
  /// [rad] with the controller's signs; where known, for languages that write configurations
  std::optional<JointAngles> joints;
};

/// A motion to angles of the axes, not to a pose. Nothing adapts it.
struct JointMove {
  std::vector<double> joints;  //!< as written, in the language's own unit
};

/// A digital output that changes, in the order of the motion.
struct SetOutput {
  std::string output;  //!< as the language names it: 5, doTool
  bool on = false;     //!< what it becomes
};

/// A statement of a program that a tool path knows about.
using Step = std::variant<Move, JointMove, SetOutput>;

/// A robot's program, whatever its language.
struct Program {
  std::string name;                   //!< of the main routine
  std::vector<std::string> comments;  //!< lines above everything else
  std::vector<Frames> frames;         //!< that its moves refer to
  std::vector<Step> steps;            //!< in the order of the motion
};

/// Of all its steps, the moves to poses, in their order.
std::vector<const Move*> moves_of(const Program& program);

/// @throw scan_cell_common::UnusableInput naming the first move that is not finite, whose rotation
/// is none, whose speed is not above 0, whose zone is negative, or that is circular without a via;
/// or if there is no move at all
void check(const Program& program);

}  // namespace tool_path_programs
