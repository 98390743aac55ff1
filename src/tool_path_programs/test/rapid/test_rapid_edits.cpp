// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "rapid/rapid_examples.h"
#include "scan_cell_common/errors/errors.h"
#include "tool_path_programs/program_path.h"

namespace tool_path_programs {
namespace {

// As written by people: tabs, CR LF, odd blanks, comments among the numbers, four decimals.
const char* const kProgram =
    "%%%\r\n  VERSION:1\r\n  LANGUAGE:ENGLISH\r\n%%%\r\n\r\nMODULE Rim\r\n"
    "\t! taught on 3 May; MoveL p10 ;\r\n"
    "  PERS tooldata "
    "tGun:=[TRUE,[[0,0,120.5],[0.7071,0,0.7071,0]],[2.1,[0,0,80],[1,0,0,0],0,0,0]];\r\n"
    "  CONST robtarget pStart:=[[ 812.34 , "
    "-55.1,\t4.0E2],[0.0175,-0.7069,0.7069,-0.0175],[0,-1,0,1],\r\n"
    "    [9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]];\r\n"
    "  CONST robtarget pEnd := "
    "[[820,-55.1,400],[0,-0.70710678,0.70710678,0],[0,-1,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]];\r\n"
    "  CONST jointtarget jHome:=[[0,-20,30,0,60,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\r\n"
    "\r\n  PROC main()\r\n    MoveAbsJ jHome\\NoEOffs,v1000,z50,tGun;\r\n"
    "    Clean 3, \\Fast;   ! the nozzle\r\n    WaitDI diReady,1;\r\n"
    "\tArcLStart\tpStart , v200,seam1,weld1 \\Weave:=zigzag,fine,tGun\\WObj:=wRim;\r\n"
    "    SetDO doGun, 1 ;\r\n"
    "    ArcL [[815,-50,400],[0,-0.7071,0.7071,0],[0,-1,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]], "
    "v20,seam1,weld1,z1,tGun\\WObj:=wRim; ArcC "
    "pStart,pEnd,v20,seam1,weld1,fine,tGun\\WObj:=wRim;\r\n"
    "    Reset doGun;\r\n    IF nCount>3 THEN\r\n      TPWrite \"p10 := [[1,2,3],[1,0,0,0]]\";\r\n"
    "    ENDIF\r\n  ENDPROC\r\nENDMODULE\r\n";

ReadSettings known() {
  ReadSettings settings;
  settings.calls_without_motion = {"clean"};
  return settings;
}

ProgramText example() {
  return read_rapid_text(kProgram, known());
}

std::vector<Eigen::Isometry3d> poses_in(const ProgramText& text) {
  std::vector<Eigen::Isometry3d> poses;
  for (const PoseText& pose : text.poses)
    poses.push_back(pose.pose);
  return poses;
}

/// A text without the numbers of poses.
std::string without_digits(const std::string& text) {
  std::string rest;
  for (const char character : text)
    if (std::string("0123456789.-").find(character) == std::string::npos) rest += character;
  return rest;
}

TEST(RapidEdits, TheSamePosesChangeNothing) {
  const ProgramText text = example();
  ASSERT_EQ(text.poses.size(), 3u);
  ASSERT_EQ(text.program.steps.size(), 6u);
  EXPECT_TRUE(rapid().edits(text, poses_in(text)).empty());
}

TEST(RapidEdits, OtherPosesChangeTheirNumbersAlone) {
  const ProgramText text = example();
  std::vector<Eigen::Isometry3d> poses = poses_in(text);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    poses[i].translation() += Eigen::Vector3d(0.00123456, -0.0021, 0.0003 * (i + 1));
    poses[i].linear() = Eigen::AngleAxisd(0.01, Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix() *
                        poses[i].linear();
  }
  const auto files = with_poses(rapid(), text, known(), poses);
  const std::string& now = files.front().text;
  std::string before = kProgram;
  before.replace(before.find("4.0E2"), 5, "4.02");  // numbers are written without exponents
  EXPECT_EQ(without_digits(now), without_digits(before));
  const ProgramText again = rapid().read(files, known());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_LT((again.poses[i].pose.translation() - poses[i].translation()).norm(), 1e-6);
    EXPECT_LT(Eigen::Quaterniond(again.poses[i].pose.linear())
                  .angularDistance(Eigen::Quaterniond(poses[i].linear())),
              0.001 * M_PI / 180);
  }
  for (const char* const part :
       {"TRUE,[[0,0,120.5],[0.7071,0,0.7071,0]],[2.1,", "Clean 3, \\Fast;", "SetDO doGun, 1 ;\r\n",
        "\"p10 := [[1,2,3],[1,0,0,0]]\"", "[0,-1,0,1],\r\n    [9E+09,", "[[0,-20,30,0,60,0],"})
    EXPECT_NE(now.find(part), std::string::npos) << part;
  EXPECT_NE(now.find("[[ 813.5746 , -57.2000,\t400.3000],["), std::string::npos);
}

TEST(RapidEdits, QuaternionsKeepTheirSign) {
  const ProgramText text = example();
  std::vector<Eigen::Isometry3d> poses = poses_in(text);
  poses[2].linear() = Eigen::AngleAxisd(1e-4, Eigen::Vector3d::UnitZ()) * poses[2].linear();
  const auto files = with_poses(rapid(), text, known(), poses);
  EXPECT_NE(files.front().text.find(",-0.70"), std::string::npos);
  EXPECT_EQ(files.front().text.find("pEnd := [[820,-55.1,400],[-0.0000354,"), std::string::npos);
  EXPECT_NE(files.front().text.find("pEnd := [[820,-55.1,400],["), std::string::npos);
}

}  // namespace
}  // namespace tool_path_programs
