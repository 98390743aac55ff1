// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pdl2/pdl2.h"
#include "pdl2_reader/pdl2_conventions.h"
#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

SourceFile program(const std::string& body, const std::string& declarations = "") {
  return {"part.pdl", "PROGRAM part\n" + declarations + "BEGIN\n" + body + "\nEND part\n"};
}

ProgramText read(const std::string& body, const std::string& declarations = "") {
  return pdl2().read({program(body, declarations)}, {});
}

std::string refusal(const std::vector<SourceFile>& files) {
  try {
    pdl2().read(files, {});
  } catch (const UnusableInput& error) {
    return error.what();
  }
  return "";
}

std::string refusal(const std::string& body, const std::string& declarations = "") {
  return refusal({program(body, declarations)});
}

const Move& move(const ProgramText& text, std::size_t step) {
  return std::get<Move>(text.program.steps.at(step));
}

bool is(const Eigen::Isometry3d& pose, const Pdl2Numbers& numbers) {
  return pose.isApprox(pdl2_pose(numbers), 1e-12);
}

testing::AssertionResult names(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    if (text.find(part) == std::string::npos)
      return testing::AssertionFailure() << "no '" << part << "' in: " << text;
  return testing::AssertionSuccess();
}

TEST(Pdl2Reader, ReadsAProgramOfAPostProcessor) {
  const ProgramText text = pdl2().read(
      {{"rim.pdl",
        "PROGRAM rim\nVAR\nROUTINE R_rim EXPORTED FROM rim GLOBAL\n\nROUTINE R_rim\nVAR\n"
        "  pxtn: XTNDPOS\nBEGIN\n  $ORNT_TYPE := RS_WORLD\n  $CNFG_CARE := TRUE\n"
        "  $FLY_DIST := 2.500\n  -- a comment, it's one\n"
        "  $UFRAME := POS(807.7665, -963.6999, 41.4789, 0.0000, 0.0000, 0.0000, '')\n"
        "  $TOOL := POS(62.5000, -108.2532, 100.0000, -60.0000, 90.0000, 0.0000, '')\n"
        "  $SPD_OPT := SPD_LIN\n  $LIN_SPD := 0.020\n"
        "  MOVE TO {-46.18419,-6.77518,-20.54925,71.38674,49.58727,-302.54752}\n"
        "  MOVEFLY LINEAR TO POS(200.0000, 250.0000, 348.7346, 180, 90, -150, 'W T1:0') ADVANCE\n"
        "  $DOUT[3] := ON\n  DELAY 1000\n"
        "  MOVE CIRCULAR TO POS(1, 2, 3, 4, 5, 6, '') VIA POS(7, 8, 9, 10, 11, 12)\n"
        "  pxtn.POS := POS(5, 6, 7, 0, 90, 0, '')\n  pxtn.AUX[1] := 3\n  MOVE LINEAR TO pxtn\n"
        "END R_rim\n\nBEGIN\n  R_rim\nEND rim\n"}},
      {});
  EXPECT_EQ(text.program.name, "rim");
  ASSERT_EQ(text.program.steps.size(), 5u);
  EXPECT_EQ(std::get<JointMove>(text.program.steps[0]).joints.size(), 6u);
  EXPECT_TRUE(is(move(text, 1).pose, {200, 250, 348.7346, 180, 90, -150}));
  EXPECT_DOUBLE_EQ(move(text, 1).zone, 0.0025);
  EXPECT_DOUBLE_EQ(move(text, 1).speed, 0.02);
  EXPECT_EQ(std::get<SetOutput>(text.program.steps[2]).output, "3");
  EXPECT_TRUE(is(*move(text, 3).via, {7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(move(text, 3).zone, 0);
  EXPECT_TRUE(is(move(text, 4).pose, {5, 6, 7, 0, 90, 0}));
  const Frames& frames = text.program.frames[move(text, 1).frames];
  EXPECT_TRUE(is(*frames.tool.pose, {62.5, -108.2532, 100, -60, 90, 0}));
  EXPECT_TRUE(is(*frames.user.pose, {807.7665, -963.6999, 41.4789, 0, 0, 0}));
}

TEST(Pdl2Reader, ReadsTaughtPositionsFromTheListingOfTheVariables) {
  const ProgramText text = pdl2().read(
      {{"seam.pdl",
        "PROGRAM seam PROG_ARM = 1, HOLD\r\nVAR home : JOINTPOS FOR ARM[1]\r\n"
        "  p1, p2 : POSITION\r\n  x3 : XTNDPOS FOR ARM[1]\r\nBEGIN\r\nCYCLE\r\n  MOVE TO home\r\n"
        "  MOVE LINEAR TO p1,\r\n    WITH $LIN_SPD = 0.3, $PROG_SPD_OVR = 50,\r\n"
        "    WITH CONDITION[1],\r\n  ENDMOVE\r\n  $MOVE_TYPE := LINEAR; MOVE TO p2\r\n"
        "  MOVE JOINT TO x3 WITH $PROG_SPD_OVR = 20\r\nEND seam\r\n"},
       {"SEAM.LSV",
        "p1 POS Priv X:1.5 Y:-2.0 Z:3.0 A:0.0 E:90.0 R:0.0 CNFG: 'W'\r\n\r\n"
        "n INT Priv 3\r\nP2 POS Priv\r\n X:4 Y:5 Z:6\r\n A:1 E:2 R:3 CNFG: ''\r\n"
        "x3 XTND Arm 1 Ax X:7 Y:8 Z:9 A:1 E:2 R:3 CNFG: ''\r\n"}},
      {});
  ASSERT_EQ(text.program.steps.size(), 4u);
  EXPECT_TRUE(std::get<JointMove>(text.program.steps[0]).joints.empty());
  EXPECT_TRUE(is(move(text, 1).pose, {1.5, -2, 3, 0, 90, 0}));
  EXPECT_DOUBLE_EQ(move(text, 1).speed, 0.15);
  EXPECT_EQ(move(text, 2).kind, MotionKind::kLinear);
  EXPECT_TRUE(is(move(text, 2).pose, {4, 5, 6, 1, 2, 3}));
  EXPECT_EQ(move(text, 2).speed, Move().speed);
  EXPECT_EQ(move(text, 3).kind, MotionKind::kJoint);
  EXPECT_DOUBLE_EQ(move(text, 3).joint_speed, 0.2);
  EXPECT_EQ(text.poses[*text.steps[1].pose].place.file, 1u);
}

TEST(Pdl2Reader, TheUserFrameIsSeenFromTheRobotsBase) {
  const ProgramText text = read(
      "$BASE := POS(0, 0, 500, 90, 0, 0, '')\n$UFRAME := POS(1000, 0, 0, 0, 0, 0, '')\n"
      "MOVE LINEAR TO POS(1, 2, 3, 0, 0, 0, '')\n$UFRAME := table\n"
      "MOVE LINEAR TO POS(1, 2, 4, 0, 0, 0, '')",
      "VAR\n  table : POSITION EXPORTED FROM cell\n");
  EXPECT_TRUE(is(*text.program.frames[0].user.pose, {0, -1000, -500, -90, 0, 0}));
  EXPECT_EQ(text.program.frames[1].user.name, "cell.table");
  EXPECT_FALSE(text.program.frames[1].user.pose);
}

TEST(Pdl2Reader, FollowsCallsAndVariables) {
  const ProgramText text = pdl2().read(
      {{"main.pdl",
        "PROGRAM main\nVAR p : POSITION\nROUTINE sub EXPORTED FROM other\nROUTINE here(n : "
        "INTEGER)\n"
        "VAR p : POSITION\nBEGIN\n  p := POS(3,0,0,0,0,0,'')\n  MOVE LINEAR TO p\nEND here\nBEGIN\n"
        "  p := POS(1,0,0,0,0,0,'')\n  MOVE LINEAR TO p\n  sub\n  here(3)\n  MOVE LINEAR TO p\n"
        "END main\n"},
       {"other.pdl",
        "PROGRAM other\nROUTINE sub EXPORTED FROM other\nROUTINE sub\nBEGIN\n"
        "  MOVE LINEAR TO POS(2,0,0,0,0,0,'')\nEND sub\nBEGIN\nEND other\n"}},
      {});
  ASSERT_EQ(text.program.steps.size(), 4u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(move(text, i).pose.translation().x(), 0.001 * double(i + 1), 1e-12);
  EXPECT_EQ(text.steps[3].pose, text.steps[0].pose);
}

TEST(Pdl2Reader, ConditionsWithoutMotionsArePassedOver) {
  const ProgramText text = read(
      "CONDITION[1]:\n WHEN $DIN[3] DO\n  $DOUT[3] := OFF\nENDCONDITION\nENABLE CONDITION[1]\n"
      "MOVE LINEAR TO POS(1,0,0,0,0,0,'')\nIF $DIN[1] = ON THEN\n  $DOUT[2] := ON\nELSE\n"
      "  FOR i := 1 TO 3 DO\n    WRITE (i, NL)\n  ENDFOR\nENDIF\nWAIT FOR $DIN[4] = ON\n"
      "REPEAT\n  DELAY 1\nUNTIL ($DIN[5] = ON)\nMOVE LINEAR TO POS(2,0,0,0,0,0,'')");
  EXPECT_EQ(text.program.steps.size(), 2u);
}

TEST(Pdl2Reader, RefusesWhatOnlyTheControllerKnowsWithFileAndLine) {
  const std::string p = "p := POS(1,0,0,0,0,0,'')\n";
  EXPECT_TRUE(names(refusal(p + "p.X := p.X + 10\nMOVE TO p"), {"part.pdl, line 5", "line 4"}));
  EXPECT_TRUE(names(refusal(p + "MOVE TO p : POS(1,0,0,0,0,0,'')"), {"line 4", "computed"}));
  EXPECT_TRUE(names(refusal("MOVE LINEAR TO POS(x,0,0,0,0,0,'')"), {"line 3", "computed"}));
  EXPECT_TRUE(names(refusal("MOVE LINEAR TO POS(1+2,0,0,0,0,0,'')"), {"line 3", "computed"}));
  EXPECT_TRUE(names(refusal("MOVE TO pnt1", "VAR pnt1 : POSITION\n"), {"line 4", ".lsv"}));
  EXPECT_TRUE(names(refusal("MOVE NEAR p BY 10"), {"line 3", "relative"}));
  EXPECT_TRUE(names(refusal(p + "MOVE LINEAR TO p SYNCMOVE TO q"), {"line 4", "arm"}));
  EXPECT_TRUE(names(refusal("MOVE LINEAR TO pts[i]"), {"line 3"}));
  EXPECT_TRUE(names(refusal(p + "IF b THEN\np := q\nENDIF\nMOVE TO p"), {"line 7", "computed"}));
  EXPECT_TRUE(names(refusal(p + "MOVE CIRCULAR TO p"), {"line 4", "VIA"}));
}

TEST(Pdl2Reader, RefusesMotionsWhoseOrderIsOpenAndCallsOfWhatIsNotGiven) {
  const std::string line = "MOVE LINEAR TO POS(1,0,0,0,0,0,'')\n";
  const std::string sub = "ROUTINE sub\nBEGIN\n" + line + "END sub\n";
  EXPECT_TRUE(names(refusal("IF b THEN\n" + line + "ENDIF"), {"line 4", "condition"}));
  EXPECT_TRUE(names(refusal("FOR i := 1 TO 3 DO\n  sub\nENDFOR", sub), {"line 8", "sub moves"}));
  EXPECT_TRUE(names(refusal(line + "GOTO again"), {"line 4", "GOTO"}));
  EXPECT_TRUE(names(refusal("WHILE b DO\n x := 1"), {"does not end"}));
  EXPECT_TRUE(names(refusal(line + "Gripper(3)"), {"part.pdl, line 4", "gripper"}));
  ReadSettings settings;
  settings.calls_without_motion = {"GRIPPER"};
  EXPECT_NO_THROW(pdl2().read({program(line + "Gripper(3)")}, settings));
  EXPECT_TRUE(
      names(refusal("sub", "ROUTINE sub\nBEGIN\nsub\n" + line + "END sub\n"), {"calls itself"}));
  EXPECT_TRUE(names(refusal({{"a.lsv", "p POS Priv X:1 Y:1 Z:1 A:1 E:1 R:1\n"}}), {"no BEGIN"}));
}

}  // namespace
}  // namespace tool_path_programs
