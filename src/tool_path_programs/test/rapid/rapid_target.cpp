// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzzing/robot_program_targets.h"
#include "rapid/rapid.h"

namespace {

const char* const kDeclared =
    "MODULE part\nPERS tooldata t:=[TRUE,[[0,0,99],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];\n"
    "PERS wobjdata w:=[FALSE,TRUE,\"\",[[9,0,0],[0,0,0,1]],[[1,2,0],[1,0,0,0]]];\n"
    "CONST robtarget p{2}:=[[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],\n"
    " [[4,5,6],[0.7071,0,0.7071,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]];\n"
    "LOCAL VAR robtarget q:=[[7,8,9],[0,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
    "PROC main()\n MoveJ q,v1000,z50,t;\n sub;\n q:=[[7,8,10],[0,1,0,0],[0,0,0,0],[0,0,0,0,0,0]];\n"
    " MoveL q,v100\\V:=33,z10\\Z:=7,t\\WObj:=w;\n MoveC p{1},p{2},v20,fine,t;\nENDPROC\n"
    "PROC sub()\n VAR num n:=3;\n MoveAbsJ [[1,2,3,4,5,6],[9E9]],v50,fine,t;\n SetDO doGun,1;\n"
    " ArcL p{2},[20,500,5000,1000],seam,weld\\Weave:=zig,[FALSE,1,1,1,1,1,1],t\\WObj:=w;\n"
    " RETURN;\nERROR\n RETRY;\nENDPROC\nTRAP tr\n n:=n+1;\nENDTRAP\nENDMODULE\n";
const char* const kConditions =
    "%%%\r\n VERSION:1\r\n%%%\r\nMODULE m(SYSMODULE)\r\n! comment\r\nFUNC num f(num x,\\switch "
    "y)\r\n"
    " RETURN x;\r\nENDFUNC\r\nRECORD r\r\n num a;\r\nENDRECORD\r\nPROC main()\r\n"
    " IF a=1 Set do1;\r\n IF (a>3 AND NOT b) OR f(x{2},\"then\")=2 THEN\r\n  n:=1;\r\n"
    " ELSEIF c THEN\r\n  Stop;\r\n ELSE\r\n  Incr n;\r\n ENDIF\r\n"
    " FOR i FROM 1 TO 3 DO\r\n  WHILE TRUE DO\r\n   WaitTime 1;\r\n  ENDWHILE\r\n ENDFOR\r\n"
    " TEST n\r\n CASE 1,2:\r\n  SetDO do2,0;\r\n DEFAULT:\r\n  TPWrite \"x\"\"y\";\r\n ENDTEST\r\n"
    " lab:\r\n VelSet 50,200;\r\n"
    " MoveLDO [[1,2,3],[1,0,0,0],[0,-1,2,1],[9E9,9E9,9E9,9E9,9E9,9E9]],v50,z1,tool0,do3,high;\r\n"
    "ENDPROC\r\nENDMODULE\r\n";

}  // namespace

scan_cell_common::FuzzTarget rapid_target() {
  return {
      "rapid",
      {kDeclared, kConditions},
      {"MODULE ", "ENDMODULE", "PROC ",      "ENDPROC", "FUNC ",  "TRAP ",     "IF ",
       "THEN",    "ENDIF",     "FOR ",       "DO ",     "TEST ",  "CASE ",     "GOTO ",
       "RETURN;", "ERROR",     "MoveL ",     "MoveC ",  "MoveJ ", "MoveAbsJ ", "ArcLEnd ",
       "SetDO ",  "VelSet ",   "sub;",       "main;",   ":=",     "\\WObj:=w", "\\V:=",
       "\\T:=",   "{1}",       "[[",         "]]",      "9E9",    "v50",       "fine",
       "VAR ",    "LOCAL ",    "robtarget ", "!",       "\""},
      [](const std::string& bytes) { check_robot_program(tool_path_programs::rapid(), bytes); }};
}
