// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "fanuc/fanuc.h"
#include "tool_path_programs/read_back.h"

namespace tool_path_programs {

inline Program empty_fanuc_program() {
  Program program;
  program.name = "PART";
  program.frames = {{{"1", std::nullopt}, {"2", std::nullopt}}};
  return program;
}

inline Move fanuc_move(double x, double y, double z, double speed = 0.05, double zone = 0.001) {
  Move move;
  move.pose.translation() << x, y, z;
  move.speed = speed;
  move.zone = zone;
  return move;
}

/// A program of these statements, with positions P[1] at 100 200 300 mm, P[2] 10 mm beside it in
/// the middle of its tool's turn, P[3] by joint angles, P[4] never taught.
inline std::string fanuc_program(const std::string& statements, const std::string& name = "PART") {
  return "/PROG  " + name + "\n/ATTR\nOWNER\t\t= MNEDITOR;\nCOMMENT\t\t= \"o'clock; /MN\";\n/MN\n" +
         statements +
         "/POS\n"
         "P[1]{\n   GP1:\n\tUF : 2, UT : 1,\t\tCONFIG : 'N U T, 0, 0, 0',\n"
         "\tX =   100.000  mm,\tY =   200.000  mm,\tZ =   300.000  mm,\n"
         "\tW =      .000 deg,\tP =      .000 deg,\tR =      .000 deg\n};\n"
         "P[2:\"it's here\"]{\n   GP1:\n\tUF : 2, UT : 1,\t\tCONFIG : 'F D B, 0, 1, -1',\n"
         "\tX = 110 mm, Y = 200.0 mm,\tZ = 3.0E2  mm,\n"
         "\tW =   -90.000 deg,\tP =     -.384 deg,\tR =   179.9999 deg,\n\tE1=  12.5  mm\n"
         "   GP2:\n\tUF : 3, UT : 4,\n\tJ1=     6.378 deg\n};\n"
         "P[3]{\n   GP1:\n\tUF : 2, UT : 1,\n\tJ1=     1.000 deg,\tJ2=   -20.500 deg,\n"
         "\tJ3=  0 deg,\tJ4=  4 deg,\tJ5=  -90 deg,\tJ6=  6 deg\n};\n"
         "P[4]{\n   GP1:\n\tUF : 2, UT : 1,\t\tCONFIG : 'N U T, 0, 0, 0',\n"
         "\tX =  ********  mm,\tY =  ********  mm,\tZ =  ********  mm,\n"
         "\tW =  ******** deg,\tP =  ******** deg,\tR =  ******** deg\n};\n/END\n";
}

}  // namespace tool_path_programs
