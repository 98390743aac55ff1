// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "krl/krl.h"
#include "krl_values/krl_conventions.h"
#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

ProgramText read(const std::string& body, const ReadSettings& settings = {}) {
  return krl().read({{"part.src", "DEF part( )\n" + body + "\nEND\n"}}, settings);
}

std::string refusal(const std::vector<SourceFile>& files, const ReadSettings& settings = {}) {
  try {
    krl().read(files, settings);
  } catch (const UnusableInput& error) {
    return error.what();
  }
  return "";
}

std::string refusal(const std::string& body) {
  return refusal({{"part.src", "DEF part( )\n" + body + "\nEND\n"}});
}

const Move& move(const ProgramText& text, std::size_t step) {
  return std::get<Move>(text.program.steps.at(step));
}

bool is(const Eigen::Isometry3d& pose, const KrlNumbers& numbers) {
  return pose.isApprox(krl_pose(numbers), 1e-12);
}

bool names(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    if (text.find(part) == std::string::npos) {
      ADD_FAILURE() << "no '" << part << "' in: " << text;
      return false;
    }
  return true;
}

const char* const kTaught =
    "&ACCESS RVP\r\n&REL 8\r\nDEF  seam1( )\r\n;FOLD INI;%{PE}\r\n"
    "  GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )\r\n  INTERRUPT ON 3\r\n"
    "  BAS (#INITMOV,0 )\r\n;ENDFOLD (INI)\r\n\r\n"
    ";FOLD PTP HOME  Vel= 100 % DEFAULT;%{PE}%MKUKATPBASIS\r\n$BWDSTART = FALSE\r\n"
    "PDAT_ACT=PDEFAULT\r\nFDAT_ACT=FHOME\r\nBAS (#PTP_PARAMS,100 )\r\n$H_POS=XHOME\r\n"
    "PTP  XHOME\r\n;ENDFOLD\r\n"
    "$BWDSTART=FALSE\r\nPDAT_ACT=PPDAT1\r\nFDAT_ACT=FP1\r\nBAS(#PTP_PARAMS,30)\r\nPTP XP1 C_DIS\r\n"
    "WAIT FOR ( $IN[7] )\r\n$OUT[12]=TRUE ; torch\r\n"
    "LDAT_ACT=LCPDAT1\r\nFDAT_ACT=FP2\r\nBAS(#CP_PARAMS,0.012)\r\nLIN XP2 C_DIS C_DIS\r\n"
    "TRIGGER WHEN DISTANCE=1 DELAY=0 DO $OUT[12]=FALSE\r\n"
    "FDAT_ACT=FP3\r\nBAS(#CP_PARAMS,0.02)\r\nCIRC XP3, XP4\r\nEND\r\n";
const char* const kTaughtData =
    "&ACCESS RVP\r\nDEFDAT  SEAM1\r\nEXT BAS (BAS_COMMAND  :IN,REAL  :IN )\r\n"
    "DECL INT SUCCESS\r\n"
    "DECL FDAT FP1={TOOL_NO 2,BASE_NO 0,IPO_FRAME #BASE,POINT2[] \" \",TQ_STATE FALSE}\r\n"
    "DECL E6POS XP1={X 100.5,Y -20,Z 300,A 10,B 20,C 30,S 2,T 35,E1 0.0,E2 0.0}\r\n"
    "FDAT FP2={TOOL_NO 2,BASE_NO 5,IPO_FRAME #BASE,POINT2[] \" \"}\r\n"
    "DECL LDAT LCPDAT1={VEL 2.0,ACC 100.0,APO_DIST 1.5,APO_FAC 50.0,ORI_TYP #VAR}\r\n"
    "DECL E6POS XP2={X 1,Y 2,Z 3,A 0,B 0,C 0,S 2,T 35}\r\n"
    "DECL FDAT FP3={TOOL_NO 2,BASE_NO 5,IPO_FRAME #BASE}\r\n"
    "DECL POS XP3={X 11,Y 12,Z 3,A 0,B 0,C 0},XP4={X 21,Y 2,Z 3,A 0,B 0,C 0}\r\nENDDAT\r\n";

std::vector<SourceFile> taught() {
  return {{"seam1.src", kTaught}, {"seam1.dat", kTaughtData}};
}

TEST(KrlReader, ReadsAProgramThatWasTaughtWithInlineForms) {
  const ProgramText text = krl().read(taught(), {});
  EXPECT_EQ(text.program.name, "seam1");
  ASSERT_EQ(text.program.steps.size(), 6u);
  EXPECT_TRUE(std::holds_alternative<JointMove>(text.program.steps[0]));
  EXPECT_EQ(move(text, 1).kind, MotionKind::kJoint);
  EXPECT_DOUBLE_EQ(move(text, 1).joint_speed, 0.3);
  EXPECT_TRUE(is(move(text, 1).pose, {100.5, -20, 300, 10, 20, 30}));
  EXPECT_EQ(std::get<SetOutput>(text.program.steps[2]).output, "12");
  EXPECT_DOUBLE_EQ(move(text, 3).speed, 0.012);
  EXPECT_DOUBLE_EQ(move(text, 3).zone, 0.0015);
  EXPECT_EQ(move(text, 4).kind, MotionKind::kCircular);
  EXPECT_TRUE(is(*move(text, 4).via, {11, 12, 3, 0, 0, 0}));
  EXPECT_TRUE(is(move(text, 4).pose, {21, 2, 3, 0, 0, 0}));
  EXPECT_EQ(move(text, 4).zone, 0);
  EXPECT_FALSE(std::get<SetOutput>(text.program.steps[5]).on);
  EXPECT_EQ(text.steps[1].place.line, 22u);
  EXPECT_EQ(text.poses[*text.steps[1].pose].place.file, 1u);
}

TEST(KrlReader, FramesComeFromTheDataOfTheRobotOrFromThePersonOrStayUnknown) {
  ProgramText text = krl().read(taught(), {});
  const Frames& frames = text.program.frames[move(text, 3).frames];
  EXPECT_EQ(frames.tool.name, "TOOL_DATA[2]");
  EXPECT_EQ(frames.user.name, "BASE_DATA[5]");
  EXPECT_FALSE(frames.user.pose);
  EXPECT_TRUE(
      text.program.frames[move(text, 1).frames].user.pose->isApprox(Eigen::Isometry3d::Identity()));
  std::vector<SourceFile> files = taught();
  files.push_back({"$config.dat", "DEFDAT $CONFIG\nBASE_DATA[5]={X 1000,Y 0,Z 0,A 0,B 0,C 0}\n"});
  text = krl().read(files, {});
  EXPECT_TRUE(is(*text.program.frames[move(text, 3).frames].user.pose, {1000, 0, 0, 0, 0, 0}));
  ReadSettings settings;
  settings.frames["BASE_DATA[5]"] = krl_pose({7, 0, 0, 0, 0, 0});
  text = krl().read(files, settings);
  EXPECT_TRUE(is(*text.program.frames[move(text, 3).frames].user.pose, {7, 0, 0, 0, 0, 0}));
}

TEST(KrlReader, ReadsAProgramOfAPostProcessor) {
  const ProgramText text = read(
      "$BASE = {FRAME: X 0.000,Y -1000.000,Z 0.000,A 0.000,B 0.000,C 0.000}\n"
      "$TOOL={FRAME: X 466.604, Y -4.165, Z 109.636, A -0.000, B 90.000, C 0.000}\n"
      "$VEL.CP = 1.00000\n$APO.CDIS = 2\n"
      "PTP {A1 107.78457,A2 -44.95260,A3 141.64681,A4 107.66839,A5 -87.93467,A6 6.37710}\n"
      "LIN {X -0.000,Y -0.000,Z 6.350,A -180.000,B 0.000,C -180.000} C_DIS\n"
      "$VEL = {CP 0.02117, ORI1 200, ORI2 200}\nlin {e6pos: x 276.225,y 1e1,z +6.35,a 0,b 0,c 0}");
  EXPECT_EQ(std::get<JointMove>(text.program.steps[0]).joints.size(), 6u);
  EXPECT_TRUE(is(move(text, 1).pose, {0, 0, 6.35, -180, 0, -180}));
  EXPECT_DOUBLE_EQ(move(text, 1).zone, 0.002);
  EXPECT_TRUE(is(move(text, 2).pose, {276.225, 10, 6.35, 0, 0, 0}));
  EXPECT_DOUBLE_EQ(move(text, 2).speed, 0.02117);
  EXPECT_TRUE(is(*text.program.frames[0].tool.pose, {466.604, -4.165, 109.636, 0, 90, 0}));
  EXPECT_TRUE(is(*text.program.frames[0].user.pose, {0, -1000, 0, 0, 0, 0}));
}

TEST(KrlReader, ReadsSplineMotionsWithSettingsOfTheirOwn) {
  std::vector<SourceFile> files = taught();
  files[0].text =
      "DEF seam1()\n$VEL.CP=0.2\nSPTP XP1 WITH $VEL_AXIS[1]=SVEL_JOINT(40.0), "
      "$TOOL=STOOL2(FP1), $BASE=SBASE(FP1.BASE_NO)\n"
      "SLIN XP2 WITH $VEL=SVEL_CP(0.015, , LCPDAT1), $TOOL=STOOL2(FP2), "
      "$BASE=SBASE(FP2.BASE_NO),$IPO_MODE=SIPO_MODE(FP2.IPO_FRAME), $APO=SAPO(LCPDAT1) C_SPL\n"
      "SCIRC XP3, XP4\nEND\n";
  const ProgramText text = krl().read(files, {});
  EXPECT_DOUBLE_EQ(move(text, 0).joint_speed, 0.4);
  EXPECT_DOUBLE_EQ(move(text, 1).speed, 0.015);
  EXPECT_DOUBLE_EQ(move(text, 1).zone, 0.0015);
  EXPECT_EQ(text.program.frames[move(text, 1).frames].user.name, "BASE_DATA[5]");
  EXPECT_DOUBLE_EQ(move(text, 2).speed, 0.2);
  EXPECT_NE(text.program.frames[move(text, 2).frames].user.name, "BASE_DATA[5]");
}

TEST(KrlReader, FollowsCallsInTheOrderOfTheMotion) {
  const std::vector<SourceFile> files = {
      {"main.src",
       "DEF main()\nLIN {X 1,Y 0,Z 0,A 0,B 0,C 0}\nsub(3)\nhere ( )\n"
       "LIN {X 4,Y 0,Z 0,A 0,B 0,C 0}\nEND\nDEF here()\nLIN {X 3,Y 0,Z 0,A 0,B 0,C 0}\nEND\n"},
      {"SUB.SRC", "DEF Sub(n:IN)\nLIN {X 2,Y 0,Z 0,A 0,B 0,C 0}\nEND\n"}};
  const ProgramText text = krl().read(files, {});
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(move(text, i).pose.translation().x(), 0.001 * double(i + 1), 1e-12);
  EXPECT_EQ(text.steps[1].place.file, 1u);
  EXPECT_EQ(text.steps[1].place.line, 2u);
}

TEST(KrlReader, WhatALiteralLeavesOutStaysAsItWas) {
  const ProgramText text = read("PTP {X 1,Y 2,Z 3,A 10,B 20,C 30}\nLIN {Z 5}\nLIN {X 7,Y 8}");
  EXPECT_TRUE(is(move(text, 1).pose, {1, 2, 5, 10, 20, 30}));
  EXPECT_TRUE(is(move(text, 2).pose, {7, 8, 5, 10, 20, 30}));
  EXPECT_TRUE(names(refusal("LIN {X 1,Y 2,Z 3}"), {"part.src, line 2", "give all six"}));
}

TEST(KrlReader, VariablesHoldWhatWasLastAssigned) {
  const ProgramText text = read(
      "DECL POS p1\nDECL REAL v\np1={X 1,Y 0,Z 0,A 0,B 0,C 0}\nv=0.25\n$VEL.CP=v\nLIN p1\n"
      "points[2]={X 2,Y 0,Z 0,A 0,B 0,C 0}\np1=points[2]\nLIN p1\nLIN points[2]");
  EXPECT_DOUBLE_EQ(move(text, 0).speed, 0.25);
  EXPECT_TRUE(is(move(text, 1).pose, {2, 0, 0, 0, 0, 0}));
  EXPECT_EQ(text.steps[1].pose, text.steps[2].pose);
}

TEST(KrlReader, ConditionsWithoutMotionsArePassedOver) {
  const ProgramText text = read(
      "LIN {X 1,Y 0,Z 0,A 0,B 0,C 0}\nIF $IN[3] THEN\n  $OUT[1]=TRUE\n  IF x>3 THEN\n  y=1\n"
      "  ENDIF\nELSE\n HALT\nENDIF\nFOR i=1 TO 6\n  $ACC_AXIS[i]=50\nENDFOR\n"
      "WHILE NOT $IN[4]\n WAIT SEC 0.1\nENDWHILE\nLIN {X 2,Y 0,Z 0,A 0,B 0,C 0}");
  EXPECT_EQ(text.program.steps.size(), 2u);
}

TEST(KrlReader, RefusesWhatOnlyTheControllerKnowsWithFileAndLine) {
  const std::string p = "p={X 1,Y 0,Z 0,A 0,B 0,C 0}\n";
  EXPECT_TRUE(names(refusal(p + "p.X=p.X+10\nLIN p"), {"part.src, line 4", "computed in line 3"}));
  EXPECT_TRUE(names(refusal(p + "LIN p:{X 1}"), {"line 3", "computed with ':'"}));
  EXPECT_TRUE(names(refusal("LIN XP1"), {"line 2", "XP1", ".dat"}));
  EXPECT_TRUE(names(refusal("LIN_REL {X 10}"), {"line 2", "lin_rel"}));
  EXPECT_TRUE(names(refusal("SPLINE\nSPL p\nENDSPLINE"), {"line 2", "spline"}));
  EXPECT_TRUE(names(refusal("LIN {X a,Y 0,Z 0,A 0,B 0,C 0}"), {"line 2", "X is not a number"}));
  EXPECT_TRUE(names(refusal("LIN {X 1+2,Y 0}"), {"line 2"}));
  EXPECT_TRUE(names(refusal("LIN p[i]"), {"line 2"}));
  EXPECT_TRUE(names(refusal(p + "CIRC p,p,CA 360"), {"line 3", "CA"}));
  EXPECT_TRUE(names(refusal("LIN {A1 1,A2 3}"), {"line 2", "PTP"}));
  EXPECT_TRUE(names(refusal("$IPO_MODE=#TCP"), {"line 2", "#TCP"}));
  EXPECT_TRUE(names(refusal(p + "IF b THEN\np={X 2}\nENDIF\nLIN p"), {"line 6", "computed"}));
  EXPECT_TRUE(names(refusal(p + "moved(p)\nLIN p\nEND\nDEF moved(a:OUT)\nx=1"), {"line 4"}));
}

TEST(KrlReader, RefusesMotionsWhoseOrderIsOpen) {
  const std::string line = "LIN {X 1,Y 0,Z 0,A 0,B 0,C 0}\n";
  EXPECT_TRUE(names(refusal("IF b THEN\n" + line + "ENDIF"), {"line 3", "condition"}));
  EXPECT_TRUE(names(refusal("LOOP\n" + line + "ENDLOOP"), {"line 3"}));
  EXPECT_TRUE(names(refusal("FOR i=1 TO 3\nsub()\nENDFOR\nEND\nDEF sub()\n" + line), {"line 3"}));
  EXPECT_TRUE(names(refusal("IF b THEN\n$BASE=x\nENDIF\n" + line), {"line 3"}));
  EXPECT_TRUE(names(refusal(line + "GOTO again"), {"line 3", "GOTO"}));
  EXPECT_TRUE(names(refusal("INTERRUPT DECL 5 WHEN a DO sub()\nEND\nDEF sub()\n" + line),
                    {"line 2", "sub moves"}));
  EXPECT_TRUE(names(refusal("WHILE x\n" + std::string("y=1")), {"does not end"}));
}

TEST(KrlReader, CallsOfWhatIsNotGivenAreRefusedUnlessTheyAreKnownNotToMove) {
  const std::vector<SourceFile> files = {
      {"part.src", "DEF part()\nLIN {X 1,Y 0,Z 0,A 0,B 0,C 0}\nGripper ( 3 )\nEND\n"}};
  EXPECT_TRUE(names(refusal(files), {"part.src, line 3", "gripper"}));
  ReadSettings settings;
  settings.calls_without_motion = {"GRIPPER"};
  EXPECT_EQ(krl().read(files, settings).program.steps.size(), 1u);
}

TEST(KrlReader, EndsWhateverCallsWhat) {
  EXPECT_TRUE(names(refusal("LIN {X 1,Y 0,Z 0,A 0,B 0,C 0}\npart()"), {"line 3", "calls itself"}));
  std::string deep = "DEF a0()\na1()\nEND\n";
  for (int i = 1; i < 200; ++i)
    deep += "DEF a" + std::to_string(i) + "()\na" + std::to_string(i + 1) + "()\nEND\n";
  deep += "DEF a200()\nLIN {X 1,Y 0,Z 0,A 0,B 0,C 0}\nEND\n";
  EXPECT_TRUE(names(refusal({{"a0.src", deep}}), {"40 deep"}));
  std::string wide;
  for (int i = 0; i < 30; ++i)
    wide += "DEF b" + std::to_string(i) + "()\nb" + std::to_string(i + 1) + "()\nb" +
            std::to_string(i + 1) + "()\nEND\n";
  wide += "DEF b30()\nLIN {X 1,Y 0,Z 0,A 0,B 0,C 0}\nEND\n";
  EXPECT_TRUE(names(refusal({{"b0.src", wide}}), {"2 million"}));
}

TEST(KrlReader, DataOfAnotherProgramAreNotThoseOfThisOne) {
  const std::vector<SourceFile> files = {
      {"part.src", "DEF part()\nLIN XP1\nEND\n"},
      {"other.dat", "DEFDAT other\nDECL POS XP1={X 1,Y 0,Z 0,A 0,B 0,C 0}\nENDDAT\n"}};
  EXPECT_TRUE(names(refusal(files), {"part.src, line 2", "XP1"}));
  std::vector<SourceFile> global = files;
  global[1].text = "DEFDAT other PUBLIC\nDECL GLOBAL POS XP1={X 1,Y 0,Z 0,A 0,B 0,C 0}\nENDDAT\n";
  EXPECT_EQ(krl().read(global, {}).program.steps.size(), 1u);
}

}  // namespace
}  // namespace tool_path_programs
