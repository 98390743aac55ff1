// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzzing/robot_program_targets.h"
#include "gcode/gcode.h"

namespace {

const char* const kFiveAxes =
    "%\nO1000 (RIM)\nN10 G21 G17 G90 G94 (start)\nN20 T3 M6\nG43 H3\nG54\nG64 P0.05\nM3 S1000\n"
    "G0 X0 Y0 Z50 A0 B0 C0\nG1 Z5 F300 ; down\nX10.5\nY-.5 C15\nA10 B-20\nM64 P2\nG4 P0.5\n"
    "X20 Y1 Z4 A11 B-21 C16 F250.5\nM65 P2\nG0 Z50\nM5\nM30\n%\n";
const char* const kThreeAxes =
    "G20\nG28\ng0x1y1z.5\ng1z0f10\ng2x2y1i.5j0\ng3x3y1r-.6\nG18 G2 X4 Z0 I.5 K0\nG53 G0 Z0\n"
    "G0 X0 Y0 Z1\nM8\nM9\nM2\n";
const char* const kHead = "G21 G0 X0 Y0 Z5 A0 C0\r\nG1 X1 A10 C-20 F100\r\nX2 C370\r\n";

}  // namespace

scan_cell_common::FuzzTarget gcode_target() {
  return {
      "gcode",
      {kFiveAxes, kThreeAxes, kHead},
      {"G0 ",  "G1 ",  "G2 ", "G3 ", "G90", "G91", "G20", "G21", "G28", "G53",  "G17", "G18",
       "G19",  "X",    "Y",   "Z",   "A",   "B",   "C",   "I",   "J",   "K",    "R",   "F",
       "M64 ", "M65 ", "P",   "(",   ")",   ";",   "/",   "%",   "#",   "[",    "O",   "N",
       "\n",   "\r\n", "-",   ".",   "360", "1e9", "0",   "M2",  "M9",  "G64 ", "G54"},
      [](const std::string& bytes) { check_robot_program(tool_path_programs::gcode(), bytes); }};
}
