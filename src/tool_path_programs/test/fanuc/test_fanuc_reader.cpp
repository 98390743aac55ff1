// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fanuc_examples.h"
#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

ProgramText read_text(const std::string& statements, const ReadSettings& settings = {}) {
  return fanuc().read({{"part.ls", fanuc_program(statements)}}, settings);
}

std::string fault_of(const std::string& statements, const ReadSettings& settings = {}) {
  try {
    read_text(statements, settings);
  } catch (const scan_cell_common::Error& error) {
    return error.what();
  }
  return "";
}

const Move& move_of(const ProgramText& text, std::size_t step) {
  return std::get<Move>(text.program.steps.at(step));
}

TEST(FanucReader, LinesArcsAndJointMovesAreToldApart) {
  const ProgramText text = read_text(
      "   1:  UFRAME_NUM=2 ;\n   2:  UTOOL_NUM[GP1]=1 ;\n   3:J P[1] 25% CNT50    ;\n"
      "   4:L P[2:weld's start] 60cm/min FINE ACC80 ;\n   5:C P[1]    \n    :  P[2] 12.0inch/min "
      "CR5 ;\n"
      "   6:  DO[3:gun]=ON ;\n  :J P[3] 100% FINE;\n   8:  RO[2] = OFF ;\n");
  ASSERT_EQ(text.program.steps.size(), 6u);
  EXPECT_EQ(text.program.name, "PART");
  EXPECT_EQ(move_of(text, 0).kind, MotionKind::kJoint);
  EXPECT_DOUBLE_EQ(move_of(text, 0).joint_speed, 0.25);
  EXPECT_GT(move_of(text, 0).zone, 0);
  EXPECT_TRUE(move_of(text, 0).pose.translation().isApprox(Eigen::Vector3d(0.1, 0.2, 0.3)));
  EXPECT_DOUBLE_EQ(move_of(text, 1).speed, 0.01);
  EXPECT_EQ(move_of(text, 1).zone, 0);
  EXPECT_EQ(move_of(text, 2).kind, MotionKind::kCircular);
  EXPECT_DOUBLE_EQ(move_of(text, 2).speed, 0.00508);
  EXPECT_DOUBLE_EQ(move_of(text, 2).zone, 0.005);
  EXPECT_EQ(text.steps[2].via, text.steps[0].pose);
  EXPECT_EQ(text.steps[2].pose, text.steps[1].pose);
  EXPECT_EQ(std::get<SetOutput>(text.program.steps[3]).output, "3");
  EXPECT_TRUE(std::get<SetOutput>(text.program.steps[3]).on);
  EXPECT_EQ(std::get<JointMove>(text.program.steps[4]).joints,
            (std::vector<double>{1, -20.5, 0, 4, -90, 6}));
  EXPECT_EQ(std::get<SetOutput>(text.program.steps[5]).output, "RO[2]");
  ASSERT_EQ(text.program.frames.size(), 1u);
  EXPECT_EQ(text.program.frames[0].user.name, "2");
  EXPECT_EQ(text.program.frames[0].tool.name, "1");
  EXPECT_EQ(text.poses.size(), 2u);
  EXPECT_EQ(text.steps[1].place.line, 9u);
}

TEST(FanucReader, AFramesPlaceIsThatOfTheSettings) {
  ReadSettings settings;
  settings.frames["2"] = Eigen::Isometry3d(Eigen::Translation3d(7, 8, 9));
  const ProgramText text = read_text("   1:L P[1] 5mm/sec FINE ;\n", settings);
  EXPECT_TRUE(text.program.frames[0].user.pose->translation().isApprox(Eigen::Vector3d(7, 8, 9)));
  EXPECT_FALSE(read_text("   1:L P[1] 5mm/sec FINE ;\n").program.frames[0].user.pose);
}

TEST(FanucReader, WhatMovesNothingIsPassedOver) {
  const ProgramText text = read_text(
      "   1:  !L P[9] 5mm/sec; don't ;\n   2:  ! no semicolon, it's\n   3:  //L P[9] 5mm/sec FINE "
      ";\n"
      "   4:  ;\n   5:   ;\n   6:  R[1:don't]=R[1]+1    ;\n   7:  LBL[1:again] ;\n"
      "   8:  WAIT DI[1]=ON TIMEOUT,LBL[1] ;\n   9:  IF R[1]<3,JMP LBL[1] ;\n"
      "  10:  IF (DI[2] AND !DI[3]) THEN ;\n  11:  DO[9]=ON ;\n  12:  ELSE ;\n  13:  WAIT   "
      "1.00(sec) ;\n"
      "  14:  ENDIF ;\n  15:  FOR R[2]=1 TO 3 ;\n  16:  R[3]=0 ;\n  17:  ENDFOR ;\n"
      "  18:  Arc Start[1,2] ;\n  19:  Weave Sine[1] ;\n  20:  DO[4]=PULSE,0.5sec ;\n"
      "  21:  SELECT R[1]=1,CALL CLEAN ;\n  22:         =2,CALL CLEAN ;\n  23:         ELSE,JMP "
      "LBL[2] ;\n"
      "  24:  LBL[2] ;\n  25:  CALL CLEAN(1,'x') ;\n"
      "  26:L P[1] 5mm/sec CNT10 TA  .10sec,DO[5]=ON ;\n  27:  END ;\n  28:L P[9] 5mm/sec FINE ;\n",
      {{}, {"clean"}, {}});
  ASSERT_EQ(text.program.steps.size(), 1u);
  EXPECT_EQ(text.steps[0].place.line, 31u);
}

TEST(FanucReader, CallsAreFollowedInTheOrderOfTheMotion) {
  const std::string main =
      fanuc_program("1:L P[2] 5mm/sec FINE ;\n2:  CALL SUB ;\n3:L P[2] 5mm/sec FINE ;\n");
  const std::string sub = fanuc_program("1:L P[1] 7mm/sec FINE ;\n2:  END ;\n", "SUB");
  const ProgramText text = fanuc().read({{"part.ls", main}, {"sub.ls", sub}}, {});
  ASSERT_EQ(text.program.steps.size(), 3u);
  EXPECT_DOUBLE_EQ(move_of(text, 1).speed, 0.007);
  EXPECT_EQ(text.steps[1].place.file, 1u);
  EXPECT_EQ(text.poses.size(), 2u);
}

TEST(FanucReader, WhatCannotBeResolvedIsRefusedWithFileLineAndCure) {
  EXPECT_EQ(fault_of("1:L PR[1:home] 5mm/sec FINE ;\n"),
            "part.ls, line 6: a position register, which only the controller knows; move to a "
            "position P[]");
  EXPECT_EQ(fault_of("1:L P[R[1]] 5mm/sec FINE ;\n"),
            "part.ls, line 6: a position whose number only a running program knows; write it "
            "into the program as numbers");
  EXPECT_EQ(fault_of("1:L P[4] 5mm/sec FINE ;\n"),
            "part.ls, line 6: P[4] was not taught; give it all numbers");
  EXPECT_EQ(fault_of("1:L P[5] 5mm/sec FINE ;\n"),
            "part.ls, line 6: P[5] is not in /POS; give all of the program");
  EXPECT_EQ(
      fault_of("1:  P[1]=LPOS ;\n2:L P[1] 5mm/sec FINE ;\n"),
      "part.ls, line 7: P[1] is computed at run time, in line 6; write it into the program as "
      "numbers");
  EXPECT_EQ(fault_of("1:  CALL SUB ;\n"),
            "part.ls, line 6: a call of SUB, which is not in the given files; give it, or name it "
            "as a program without motion");
  EXPECT_EQ(fault_of("1:  UFRAME_NUM=3 ;\n2:L P[1] 5mm/sec FINE ;\n"),
            "part.ls, line 7: a position in user frame 2 while 3 is selected; select that of the "
            "position");
  for (const char* const statement :
       {"L P[1] R[1]mm/sec FINE", "L P[1] WELD_SPEED FINE", "L P[1] 2.0sec FINE",
        "L P[1] 5mm/sec FINE Offset,PR[1]", "L P[1] 5mm/sec FINE INC", "L P[1] 5mm/sec CNTR[1]",
        "L P[1] 5mm/sec FINE Skip,LBL[1]", "A P[1] 5mm/sec FINE", "L P[1] 50% FINE",
        "J P[1] 0% FINE", "  UFRAME_NUM=R[1]", "  DO[R[1]]=ON", "  DO[1]=(R[1]>2)", "  CALL SR[1]"})
    EXPECT_NE(fault_of("1:" + std::string(statement) + " ;\n"), "") << statement;
}

TEST(FanucReader, MotionUnderConditionsIsRefused) {
  const std::string cure = "; give the program that moves in one order, without conditions";
  const std::string move = "2:L P[1] 5mm/sec FINE ;\n";
  EXPECT_EQ(
      fault_of("1:  IF (DI[1]) THEN ;\n" + move + "3:  ENDIF ;\n"),
      "part.ls, line 7: a motion, or a change of frames, under a condition or in a loop" + cure);
  EXPECT_EQ(fault_of("1:  LBL[1] ;\n" + move + "3:  IF R[1]<3,JMP LBL[1] ;\n"),
            "part.ls, line 8: a jump over motions, or over changes of frames" + cure);
  EXPECT_EQ(fault_of("1:  JMP LBL[1] ;\n" + move + "3:  LBL[1] ;\n"),
            "part.ls, line 6: a jump over motions, or over changes of frames" + cure);
  const std::string sub = fanuc_program(move, "SUB");
  EXPECT_THROW(
      fanuc().read({{"part.ls", fanuc_program("1:  IF DI[1]=ON,CALL SUB ;\n")}, {"sub.ls", sub}},
                   {}),
      scan_cell_common::UnusableInput);
  EXPECT_NE(fault_of("1:  FOR R[1]=1 TO 3 ;\n2:  UFRAME_NUM=2 ;\n3:  ENDFOR ;\n"), "");
  EXPECT_NE(fault_of("1:  IF R[1]=1,JMP LBL[R[2]] ;\n"), "");
  EXPECT_NE(fault_of("1:  JMP LBL[7] ;\n"), "");
  EXPECT_EQ(fault_of("1:  UFRAME[2]=PR[1] ;\n" + move), "");
  EXPECT_NE(fault_of(move + "3:  UFRAME[2]=PR[1] ;\n" + move), "");
}

TEST(FanucReader, CallsInACircleAndBrokenFilesEnd) {
  EXPECT_EQ(fault_of("1:  CALL PART ;\n"),
            "part.ls, line 6: PART calls itself; give a program without recursion");
  for (const char* const text :
       {"", "/PROG", "/PROG A", "/PROG A\n/MN", "/PROG A\n/MN\n1:L P[1]",
        "/PROG A\n/MN\n1: ENDIF ;\n/END", "/PROG A\n/MN\n1: IF (a) THEN ;\n/END",
        "/PROG A\n/MN\n1:L P[1] 5mm/sec FINE\n2:L P[2] 5mm/sec FINE ;\n/END",
        "/PROG A\n/MN\n/POS\nP[1]{", "/PROG A\n/MN\n/POS\nP[1]{ X=", "/PROG A\n/MN\n/POS\nQ",
        "/PROG A\n/MN\n/POS\nP[1]{};P[1]{};/END", "/PROG A\n/MN\n/POS\nP[",
        "/PROG A\n/MN\n1:LBL[\n/END"})
    EXPECT_THROW(fanuc().read({{"a.ls", text}}, {}), scan_cell_common::UnusableInput) << text;
}

TEST(FanucReader, CallsThatGrowBeyondAllMeasureEnd) {
  std::vector<SourceFile> files;
  for (int i = 0; i < 40; ++i) {
    std::string statements;
    for (int k = 0; k < 10 && i < 39; ++k)
      statements += std::to_string(k + 1) + ":  CALL R" + std::to_string(i + 1) + " ;\n";
    files.push_back(
        {"r" + std::to_string(i) + ".ls", fanuc_program(statements, "R" + std::to_string(i))});
  }
  EXPECT_THROW(fanuc().read(files, {}), scan_cell_common::UnusableInput);
}

}  // namespace
}  // namespace tool_path_programs
