// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzzing/robot_program_targets.h"
#include "pdl2/pdl2.h"

namespace {

const char* const kProgram =
    "PROGRAM part PROG_ARM = 1\r\nVAR\r\n  home : JOINTPOS FOR ARM[1]\r\n  p1, p2 : POSITION\r\n"
    "  gun : POSITION EXPORTED FROM tools\r\nROUTINE sub(n : INTEGER)\r\nBEGIN\r\n"
    "  MOVE LINEAR TO POS(2, 0, 0, 0, 90, 0, '')\r\nEND sub\r\nBEGIN\r\nCYCLE\r\n  $TOOL := gun\r\n"
    "  $BASE := POS(0, 0, 500, 90, 0, 0, '')\r\n  $UFRAME := POS(1e3, 0, 0, 0, 0, 0, '')\r\n"
    "  MOVE TO home\r\n  p1 := POS(1, -2, 3.5, 10, 20, 30, 'W')\r\n  p2.POS := p1\r\n"
    "  MOVE LINEAR TO p1,\r\n    WITH $LIN_SPD = 0.3, $PROG_SPD_OVR = 50,\r\n  ENDMOVE\r\n"
    "  $MOVE_TYPE := LINEAR; MOVE TO p2 -- it's\r\n  $FLY_DIST := 2\r\n  sub(3)\r\n"
    "  MOVEFLY CIRCULAR TO p1 VIA POS(7, 8, 9, 10, 0, 12) ADVANCE\r\n  $DOUT[3] := ON\r\n"
    "  IF $DIN[1] = ON THEN\r\n    $DOUT[2] := ON\r\n  ENDIF\r\n  MOVE TO {1, 2, 3}\r\nEND "
    "part\r\n";

}  // namespace

scan_cell_common::FuzzTarget pdl2_target() {
  return {"pdl2",
          {kProgram},
          {"MOVE ",     "MOVEFLY ",  "LINEAR ",     "CIRCULAR ", "JOINT ",   "TO ",
           "VIA ",      "POS(",      "{",           "}",         "(",        ")",
           "[",         "]",         ",",           ":",         ":=",       "=",
           ";",         "'",         "''",          "--",        "p1",       "p2",
           "sub",       "home",      "WITH ",       "ENDMOVE",   "ADVANCE",  "IF ",
           "ENDIF\r\n", "FOR ",      "ENDFOR\r\n",  "BEGIN\r\n", "END\r\n",  "ROUTINE ",
           "VAR\r\n",   "$TOOL := ", "$UFRAME := ", "$BASE := ", "$LIN_SPD", "$DOUT[1] := ON",
           "GOTO ",     "1e300",     "-",           ".",         "\r\n"},
          [](const std::string& bytes) { check_robot_program(tool_path_programs::pdl2(), bytes); }};
}
