// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "rapid/rapid.h"
#include "tool_path_programs/read_back.h"

namespace tool_path_programs {

/// A tool and a work object with names and poses, and no move yet.
inline Program empty_rapid_program() {
  Program program;
  program.name = "PART";
  Eigen::Isometry3d tip = Eigen::Isometry3d::Identity();
  tip.translation() << 0.01, 0.02, 0.3;
  Eigen::Isometry3d part = Eigen::Isometry3d::Identity();
  part.translation() << 1.2, -0.4, 0.5;
  part.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  program.frames = {{{"tGun", tip}, {"wPart", part}}};
  return program;
}

inline Move rapid_move(double x, double y, double z, double speed = 0.05, double zone = 0.001) {
  Move move;
  move.pose.translation() << x, y, z;
  move.speed = speed;
  move.zone = zone;
  return move;
}

inline ProgramText read_rapid_text(const std::string& text, const ReadSettings& settings = {}) {
  return rapid().read({{"part.mod", text}}, settings);
}

/// Statements in the main routine of a module that declares a tool and some positions.
inline std::string rapid_module(const std::string& statements) {
  return "MODULE m\n"
         "CONST robtarget p10:=[[100,200,300],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
         "CONST robtarget p20:=[[110,200,300],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
         "VAR robtarget pFound;\n"
         "PROC main()\n" +
         statements + "\nENDPROC\nENDMODULE\n";
}

}  // namespace tool_path_programs
