// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "rapid/rapid_examples.h"
#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

std::string fault_of(const std::string& statements, const ReadSettings& settings = {}) {
  try {
    read_rapid_text(rapid_module(statements), settings);
  } catch (const scan_cell_common::Error& error) {
    return error.what();
  }
  return "";
}

const Move& move_of(const ProgramText& text, std::size_t step) {
  return std::get<Move>(text.program.steps.at(step));
}

TEST(RapidReader, LinesArcsAndJointMovesAreToldApart) {
  const ProgramText text = read_rapid_text(rapid_module(
      "MoveJ p10, v1000, z50, tool0;\n"
      "movel\tp20,v100\\V:=33.5 ,z10\\Z:=12 ,tool0\\wobj:=wobj0 ;\n"
      "MoveC p10,p20,[25,500,5000,1000],[FALSE,7,10,10,1,10,1],tool0;\n"
      "MoveAbsJ [[1,2,3,-4,5,6.5],[9E9,9E9,9E9,9E9,9E9,9E9]]\\NoEOffs,v50,fine,tool0;\n"
      "MoveL\\Conc, [[1,2,3],[0,0,0,-1],[0,-1,2,1],[9E+09,9E9,9E9,9E9,9E9,9E9]], v50, fine, "
      "tool0;"));
  ASSERT_EQ(text.program.steps.size(), 5u);
  EXPECT_EQ(move_of(text, 0).kind, MotionKind::kJoint);
  EXPECT_DOUBLE_EQ(move_of(text, 0).joint_speed, 0.2);
  EXPECT_DOUBLE_EQ(move_of(text, 0).zone, 0.05);
  EXPECT_DOUBLE_EQ(move_of(text, 1).speed, 0.0335);
  EXPECT_DOUBLE_EQ(move_of(text, 1).zone, 0.012);
  EXPECT_EQ(move_of(text, 2).kind, MotionKind::kCircular);
  EXPECT_DOUBLE_EQ(move_of(text, 2).via->translation().x(), 0.1);
  EXPECT_DOUBLE_EQ(move_of(text, 2).pose.translation().x(), 0.11);
  EXPECT_DOUBLE_EQ(move_of(text, 2).speed, 0.025);
  EXPECT_DOUBLE_EQ(move_of(text, 2).zone, 0.007);
  EXPECT_EQ(std::get<JointMove>(text.program.steps[3]).joints,
            (std::vector<double>{1, 2, 3, -4, 5, 6.5}));
  EXPECT_EQ(move_of(text, 4).zone, 0);
  EXPECT_TRUE(move_of(text, 4).pose.linear().isApprox(
      Eigen::Vector3d(-1, -1, 1).asDiagonal().toDenseMatrix(), 1e-12));
  EXPECT_EQ(text.poses.size(), 3u);
  EXPECT_EQ(text.steps[0].pose, text.steps[2].via);
  EXPECT_EQ(text.steps[1].place.line, 7u);
  EXPECT_EQ(text.poses[0].place.line, 2u);
}

TEST(RapidReader, InstructionsOfProcessesAreMotions) {
  const ProgramText text = read_rapid_text(rapid_module(
      "ArcLStart p10, v100, seam1, weld1\\Weave:=weave1, fine, tWeld\\WObj:=wFixture;\n"
      "ArcL\\On, p20, v20, seam1, weld1, weave1, z1, tWeld;\n"
      "ArcCEnd p10,p20,v100,seam1,weld1,fine,tWeld;\n"
      "TriggL p10, v500, trigg1\\T2:=trigg2, z5, tWeld;\n"
      "MoveLDO p20, v500, z5, tWeld\\WObj:=wFixture, doAir, 1;\n"
      "DispL\\On, p10, v200, bead1, z30, tWeld;"));
  ASSERT_EQ(text.program.steps.size(), 7u);
  EXPECT_DOUBLE_EQ(move_of(text, 0).speed, 0.1);
  EXPECT_DOUBLE_EQ(move_of(text, 1).zone, 0.001);
  EXPECT_EQ(move_of(text, 2).kind, MotionKind::kCircular);
  EXPECT_DOUBLE_EQ(move_of(text, 3).zone, 0.005);
  EXPECT_EQ(std::get<SetOutput>(text.program.steps[5]).output, "doAir");
  EXPECT_TRUE(std::get<SetOutput>(text.program.steps[5]).on);
  ASSERT_EQ(text.program.frames.size(), 2u);
  EXPECT_EQ(text.program.frames[0].tool.name, "tWeld");
  EXPECT_FALSE(text.program.frames[0].tool.pose);
  EXPECT_EQ(text.program.frames[0].user.name, "wFixture");
  EXPECT_FALSE(text.program.frames[0].user.pose);
  EXPECT_EQ(text.program.frames[1].user.name, "wobj0");
}

TEST(RapidReader, FramesAreThoseOfTheDataOrTheSettings) {
  const std::string text =
      "MODULE m\n"
      "PERS tooldata t1:=[TRUE,[[0,0,100],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];\n"
      "PERS wobjdata w1:=[FALSE,TRUE,\"\",[[1000,0,0],[0,0,0,1]],[[10,20,0],[1,0,0,0]]];\n"
      "PERS wobjdata wTurned:=[FALSE,FALSE,\"STN1\",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];\n"
      "PERS robtarget p{2}:=[[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],\n"
      "  [[4,5,6],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]];\n"
      "PROC part()\nMoveL p{2},v50,fine,t1\\WObj:=w1;\nMoveL p{1},v50,fine,t1\\WObj:=wTurned;\n"
      "MoveL p{1},v50,fine,t1\\WObj:=wGiven;\nENDPROC\nENDMODULE\n";
  ReadSettings settings;
  settings.frames["WGIVEN"] = Eigen::Isometry3d(Eigen::Translation3d(7, 8, 9));
  const ProgramText read = read_rapid_text(text, settings);
  EXPECT_DOUBLE_EQ(move_of(read, 0).pose.translation().z(), 0.006);
  const auto& frames = read.program.frames;
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_TRUE(frames[0].tool.pose->translation().isApprox(Eigen::Vector3d(0, 0, 0.1)));
  EXPECT_TRUE(frames[0].user.pose->translation().isApprox(Eigen::Vector3d(0.99, -0.02, 0), 1e-9));
  EXPECT_FALSE(frames[1].user.pose);
  EXPECT_TRUE(frames[2].user.pose->translation().isApprox(Eigen::Vector3d(7, 8, 9)));
}

TEST(RapidReader, CallsAreFollowedInTheOrderOfTheMotion) {
  const std::string main =
      rapid_module("MoveL p20,v50,fine,tool0;\nweld;\nMoveL p20,v50,fine,tool0;");
  const std::string other =
      "%%%\n  VERSION:1\n  LANGUAGE:ENGLISH\n%%%\nMODULE other(NOSTEPIN)\n"
      "LOCAL CONST robtarget p10:=[[7,0,0],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
      "PROC weld()\n  VAR num n:=1;\n  MoveL p10,v50,fine,tool0;\n  RETURN;\n"
      "  MoveL p20,v50,fine,tool0;\nERROR\n  MoveL p20,v5,fine,tool0;\nENDPROC\nENDMODULE\n";
  const ProgramText text = rapid().read({{"part.mod", main}, {"other.mod", other}}, {});
  ASSERT_EQ(text.program.steps.size(), 3u);
  EXPECT_DOUBLE_EQ(move_of(text, 0).pose.translation().x(), 0.11);
  EXPECT_DOUBLE_EQ(move_of(text, 1).pose.translation().x(), 0.007);
  EXPECT_EQ(text.steps[1].place.file, 1u);
  EXPECT_EQ(text.steps[1].place.line, 9u);
}

TEST(RapidReader, ValuesThatAreAssignedAsNumbersAreFollowed) {
  const ProgramText text = read_rapid_text(
      rapid_module("pFound:=[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
                   "MoveL pFound,v50,fine,tool0;\n"
                   "pFound:=[[4,5,6],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n"
                   "MoveL pFound,v50,fine,tool0;\nVelSet 50,20;\nMoveL pFound,v30,fine,tool0;\n"
                   "MoveL pFound,v1000,fine,tool0;"));
  EXPECT_DOUBLE_EQ(move_of(text, 0).pose.translation().x(), 0.001);
  EXPECT_DOUBLE_EQ(move_of(text, 1).pose.translation().x(), 0.004);
  EXPECT_DOUBLE_EQ(move_of(text, 2).speed, 0.015);
  EXPECT_DOUBLE_EQ(move_of(text, 3).speed, 0.02);
}

TEST(RapidReader, WhatMovesNothingIsPassedOver) {
  const ProgramText text = read_rapid_text(rapid_module(
      "  ! MoveL p10,v50,fine,tool0;\n  ConfL\\Off; AccSet 50,50;\n"
      "  IF di1=1 Set do1;\n  IF (n>3 AND NOT b) OR f(x{2},\"then\")=2 THEN\n    TPWrite \"MoveL; "
      "!\";\n"
      "    FOR i FROM 1 TO 3 DO\n      Incr n;\n    ENDFOR\n  ELSEIF a THEN\n    WaitTime 1;\n  "
      "ELSE\n"
      "    n:=n+1;\n  ENDIF\n  WHILE n<3 DO n:=n+1; ENDWHILE\n  TEST n\n  CASE 1,2:\n    Stop;\n"
      "  DEFAULT:\n    Reset do2;\n  ENDTEST\n  again:\n  SetDO\\Sync,doGun,high;\n"
      "  MoveL p10,v50,fine,tool0;\n  Reset doGun;"));
  ASSERT_EQ(text.program.steps.size(), 3u);
  EXPECT_TRUE(std::get<SetOutput>(text.program.steps[0]).on);
  EXPECT_EQ(std::get<SetOutput>(text.program.steps[2]).output, "doGun");
}

TEST(RapidReader, WhatCannotBeResolvedIsRefusedWithFileLineAndCure) {
  EXPECT_EQ(fault_of("MoveL Offs(p10,0,0,50),v50,fine,tool0;"),
            "part.mod, line 6: Offs.., a value that is computed at run time; write it into the "
            "program as numbers");
  EXPECT_EQ(fault_of("pFound:=CRobT();\nMoveL pFound,v50,fine,tool0;"),
            "part.mod, line 7: pFound is computed at run time, in line 6; write it into the "
            "program as numbers");
  EXPECT_EQ(
      fault_of("MoveL pFound,v50,fine,tool0;"),
      "part.mod, line 6: pFound has no value in the text; write it into the program as numbers");
  EXPECT_EQ(fault_of("MoveL p30,v50,fine,tool0;"),
            "part.mod, line 6: p30 is not in the given files; give the module that declares it");
  EXPECT_EQ(fault_of("MoveL *,v50,fine,tool0;"),
            "part.mod, line 6: *, a position that is not in the text; give it a name");
  EXPECT_EQ(fault_of("MoveL p10,vWeld,fine,tool0;"),
            "part.mod, line 6: vWeld is not in the given files; give the module that declares it");
  EXPECT_EQ(
      fault_of("\nweld;"),
      "part.mod, line 7: a call of weld, which is not in the given files; give its module, or "
      "name it as a routine without motion");
  ReadSettings settings;
  settings.calls_without_motion = {"Weld"};
  EXPECT_EQ(fault_of("weld;", settings), "");
}

TEST(RapidReader, MotionUnderConditionsIsRefused) {
  const std::string cure = "; give the program that moves in one order, without conditions";
  EXPECT_EQ(fault_of("IF a THEN\nMoveL p10,v50,fine,tool0;\nENDIF"),
            "part.mod, line 7: MoveL under a condition or in a loop" + cure);
  EXPECT_EQ(fault_of("IF a MoveL p10,v50,fine,tool0;"),
            "part.mod, line 6: MoveL under a condition or in a loop" + cure);
  EXPECT_EQ(fault_of("FOR i FROM 1 TO 3 DO\nsub;\nENDFOR\nENDPROC\nPROC sub()\n"
                     "MoveL p10,v50,fine,tool0;"),
            "part.mod, line 11: MoveL under a condition or in a loop" + cure);
  EXPECT_EQ(fault_of("IF a pFound:=p10;\nMoveL pFound,v50,fine,tool0;"),
            "part.mod, line 7: pFound is computed at run time, in line 6; write it into the "
            "program as numbers");
  EXPECT_NE(fault_of("GOTO there;"), "");
  EXPECT_NE(fault_of("PDispOn p10,tool0;"), "");
  EXPECT_NE(fault_of("SearchL di1,pFound,p10,v50,tool0;"), "");
  EXPECT_NE(fault_of("MoveL p10,v50\\T:=3,fine,tool0;"), "");
}

TEST(RapidReader, AFrameThatIsComputedBetweenTwoMovesIsRefused) {
  const std::string head = "ENDPROC\nPERS wobjdata w;\nPROC sub()\n";
  const std::string move = "MoveL p10,v50,fine,tool0\\WObj:=w;\n";
  EXPECT_EQ(fault_of("w:=Found();\n" + move + move + head), "");
  EXPECT_NE(fault_of(move + "w:=Found();\n" + move + head), "");
}

TEST(RapidReader, CallsInACircleAndBrokenModulesEnd) {
  EXPECT_EQ(fault_of("main;"),
            "part.mod, line 6: main calls itself; give a program without recursion");
  for (const char* const text :
       {"", "MODULE", "MODULE m", "MODULE m PROC main()", "MODULE m PROC main( ENDPROC",
        "MODULE m PROC main() MoveL", "MODULE m PROC main() IF",
        "MODULE m PROC main() x:=", "MODULE m PROC main() IF a THEN ENDPROC ENDMODULE",
        "MODULE m PROC main() TEST a CASE ENDPROC ENDMODULE", "MODULE m CONST robtarget p{2}:=[[",
        "MODULE m PROC main() MoveL [[1,2,3],[2,0,0,0],[0],[0]],v5,fine,t; ENDPROC ENDMODULE",
        "MODULE m PROC a() ENDPROC PROC b() ENDPROC ENDMODULE",
        "MODULE m PROC a() ENDPROC PROC A() ENDPROC ENDMODULE"})
    EXPECT_THROW(read_rapid_text(text), scan_cell_common::UnusableInput) << text;
}

TEST(RapidReader, CallsThatGrowBeyondAllMeasureEnd) {
  std::string text = "MODULE m\nPROC main()\nr1;\nENDPROC\n";
  for (int i = 1; i < 40; ++i) {
    text += "PROC r" + std::to_string(i) + "()\n";
    for (int k = 0; k < 10; ++k)
      text += "r" + std::to_string(i + 1) + ";\n";
    text += "ENDPROC\n";
  }
  text += "PROC r40()\nENDPROC\nENDMODULE\n";
  EXPECT_THROW(read_rapid_text(text), scan_cell_common::UnusableInput);
}

}  // namespace
}  // namespace tool_path_programs
