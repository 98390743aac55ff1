// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzzing/robot_program_targets.h"
#include "krl/krl.h"

namespace {

const char* const kSource =
    "&ACCESS RVP\r\nDEF part ( )\r\n;FOLD INI\r\nDECL E6POS p1\r\nDECL REAL v\r\n"
    "GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )\r\nBAS (#INITMOV,0 )\r\n"
    "PTP XHOME\r\nFDAT_ACT=FP1\r\nBAS(#PTP_PARAMS,30)\r\nPTP XP1 C_DIS\r\n$OUT[12]=TRUE ; torch\r\n"
    "LDAT_ACT=LCPDAT1\r\nBAS(#CP_PARAMS,0.012)\r\nLIN XP1 C_DIS C_DIS\r\nv=0.3\r\n$VEL.CP=v\r\n"
    "TRIGGER WHEN DISTANCE=1 DELAY=0 DO $OUT[12]=FALSE\r\nCIRC {X 1,Y 2},XP2\r\n"
    "IF $IN[3] THEN\r\nx=1\r\nENDIF\r\nsub(3)\r\n$BASE={FRAME: X 0,Y -1e3,Z 0,A 0,B 0,C 0}\r\n"
    "p1={X 1,Y 0,Z 0,A 0,B 90,C 0,S 'B010',T 35}\r\nLIN p1\r\nLIN {Z 4}\r\nPTP {A1 10,A2 -90}\r\n"
    "$TOOL=TOOL_DATA[3]\r\nSLIN XP2 WITH $VEL=SVEL_CP(0.015, , LCPDAT1), $TOOL=STOOL2(FP1)\r\n"
    "END\r\nDEF sub(n:IN)\r\nLIN {X 2,Y 0,Z 0,A 0,B 0,C 0}\r\nEND\r\n"
    "DEFDAT part\r\nDECL FDAT FP1={TOOL_NO 2,BASE_NO 0,IPO_FRAME #BASE,POINT2[] \" \"}\r\n"
    "DECL LDAT LCPDAT1={VEL 2.0,APO_DIST 1.5}\r\nDECL POS XP2={X 11,Y 12,Z 3,A 0,B 0,C 0}\r\n"
    "DECL E6POS XP1={X 100.5,Y -20,Z 300,A 10,B 20,C 30,S 2,T 35,E1 0.0}\r\nENDDAT\r\n";

}  // namespace

scan_cell_common::FuzzTarget krl_target() {
  return {"krl",
          {kSource},
          {"LIN ",       "PTP ",
           "CIRC ",      "{",
           "}",          "{X 1,Y 2,Z 3,A 4,B 90,C 6}",
           "X ",         "A ",
           ",",          ":",
           "=",          "(",
           ")",          "[",
           "]",          "XP1",
           "XP2",        "p1",
           "sub()",      "part()",
           "END\r\n",    "DEF ",
           "IF ",        "ENDIF\r\n",
           "LOOP\r\n",   "$BASE=",
           "$TOOL=",     "$VEL.CP=",
           "$APO.CDIS=", " C_DIS",
           "WITH ",      "$OUT[1]=TRUE",
           "TRIGGER ",   "GOTO ",
           "1e300",      "-",
           ".",          "'",
           "\"",         ";",
           "\n"},
          [](const std::string& bytes) { check_robot_program(tool_path_programs::krl(), bytes); }};
}
