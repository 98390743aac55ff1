// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fanuc/fanuc.h"
#include "fanuc_examples.h"
#include "fuzzing/robot_program_targets.h"

scan_cell_common::FuzzTarget fanuc_target() {
  using tool_path_programs::fanuc_program;
  return {
      "fanuc",
      {fanuc_program(
           "   1:  UFRAME_NUM=2 ;\n   2:  UTOOL_NUM[GP1]=1 ;\n   3:J P[1] 25% CNT50    ;\n"
           "   4:L P[2:weld's start] 60cm/min FINE ACC80 ;\n"
           "   5:C P[1]    \n    :  P[2] 12.0inch/min CR5 ;\n   6:  DO[3:gun]=ON ;\n"
           "   7:J P[3] 100% FINE;\n   8:  RO[2] = OFF ;\n"),
       fanuc_program(
           "   1:  !don't ;\n   2:  LBL[1:again] ;\n   3:  IF R[1]<3,JMP LBL[1] ;\n"
           "   4:  IF (DI[2] AND !DI[3]) THEN ;\n   5:  DO[9]=ON ;\n   6:  ELSE ;\n"
           "   7:  WAIT   1.00(sec) ;\n   8:  ENDIF ;\n   9:  FOR R[2]=1 TO 3 ;\n"
           "  10:  ENDFOR ;\n  11:  SELECT R[1]=1,JMP LBL[2] ;\n  12:  ELSE,JMP LBL[2] ;\n"
           "  13:  LBL[2] ;\n  14:L P[1] 5mm/sec CNT10 TA  .10sec,DO[5]=ON ;\n"
           "  15:  END ;\n")},
      {"/PROG ", "/MN\n",  "/POS\n", "/END\n", "L P[1] ", "C P[1] ", "J ",     "PR[1]",
       "P[1]",   "CALL ",  "JMP ",   "LBL[1]", "IF ",     "THEN",    "ENDIF ", "FOR ",
       "ENDFOR", "mm/sec", "cm/min", "%",      "FINE",    "CNT100",  "CR1",    "UFRAME_NUM=",
       "DO[1]=", "ON",     " ;\n",   "{",      "};\n",    "GP1:",    "GP2:",   "UF : F",
       "CONFIG", "X = ",   "***",    "J1= ",   "'",       "!",       "//",     "  12:"},
      [](const std::string& bytes) { check_robot_program(tool_path_programs::fanuc(), bytes); }};
}
