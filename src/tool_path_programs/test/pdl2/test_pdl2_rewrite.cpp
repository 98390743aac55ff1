// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pdl2/pdl2.h"
#include "pdl2_reader/pdl2_conventions.h"
#include "tool_path_programs/program_path.h"

namespace tool_path_programs {
namespace {

const char* const kProgram =
    "PROGRAM rim PROG_ARM = 1\r\n-- keep: MOVE TO POS(1, 2, 3)\r\nVAR\r\n\tp1 : "
    "POSITION\r\nBEGIN\r\n"
    "  $LIN_SPD := 0.02 -- m/s\r\n"
    "  MOVE  JOINT TO  POS( 100.5, -20 ,3.123456,0, 90.0,\t0 , 'S W T1:1')\t-- approach\r\n"
    "  glue(TRUE); $DOUT[3] := ON\r\n  MOVEFLY LINEAR TO p1 ADVANCE WITH CONDITION[2]\r\n"
    "  DELAY 500\r\n  MOVE CIRCULAR TO POS(200,0,0,0,90,0,'') VIA\tPOS(1.5e2,0,0,0,90,0,''),\r\n"
    "    WITH $LIN_SPD = 0.01,\r\n  ENDMOVE\r\n  MOVE LINEAR TO p1\r\nEND rim\r\n";
const char* const kValues =
    "n INT Priv 12\r\n\r\np1 POS Priv X:120.00 Y:0.000\r\n   Z:0 A:0.0 E:90 R:0 CNFG: 'W'\r\n";

ReadSettings known() {
  ReadSettings settings;
  settings.calls_without_motion = {"glue"};
  return settings;
}

ProgramText rim() {
  return pdl2().read({{"rim.pdl", kProgram}, {"rim.lsv", kValues}}, known());
}

std::vector<Eigen::Isometry3d> poses_of(const ProgramText& text) {
  std::vector<Eigen::Isometry3d> poses;
  for (const PoseText& pose : text.poses)
    poses.push_back(pose.pose);
  return poses;
}

std::string without_numbers(const std::string& text) {
  std::string rest;
  for (const char character : text)
    if (std::string("0123456789.-+e").find(character) == std::string::npos) rest += character;
  return rest;
}

TEST(Pdl2Rewrite, TheSamePosesChangeNoByte) {
  const ProgramText text = rim();
  EXPECT_EQ(text.poses.size(), 4u);
  const auto files = with_poses(pdl2(), text, known(), poses_of(text));
  EXPECT_EQ(files[0].text, kProgram);
  EXPECT_EQ(files[1].text, kValues);
}

TEST(Pdl2Rewrite, OtherPosesChangeTheirNumbersAlone) {
  const ProgramText text = rim();
  std::vector<Eigen::Isometry3d> poses = poses_of(text);
  const Eigen::Isometry3d moved = Eigen::Translation3d(0.1, -0.02, 0.003) *
                                  Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 2) / 3);
  for (Eigen::Isometry3d& pose : poses)
    pose = moved * pose;
  const auto files = with_poses(pdl2(), text, known(), poses);
  EXPECT_EQ(without_numbers(files[0].text), without_numbers(kProgram));
  EXPECT_EQ(without_numbers(files[1].text), without_numbers(kValues));
  for (const char* kept : {", 'S W T1:1')\t-- approach\r\n", "-- keep: MOVE TO POS(1, 2, 3)\r\n",
                           "$LIN_SPD := 0.02 -- m/s\r\n", "WITH CONDITION[2]\r\n  DELAY 500\r\n",
                           "WITH $LIN_SPD = 0.01,\r\n  ENDMOVE\r\n", "$DOUT[3] := ON\r\n"})
    EXPECT_NE(files[0].text.find(kept), std::string::npos) << kept;
  EXPECT_NE(files[1].text.find("n INT Priv 12\r\n"), std::string::npos);
}

TEST(Pdl2Rewrite, NumbersKeepTheirDigitsAndHaveEnoughOfThem) {
  const ProgramText text = rim();
  std::vector<Eigen::Isometry3d> poses = poses_of(text);
  poses[0].translation() += Eigen::Vector3d(0.001, 0.0001, 0.0000012);
  const auto files = with_poses(pdl2(), text, known(), poses);
  EXPECT_NE(files[0].text.find("POS( 101.5000, -19.9000 ,3.124656,0, 90.0,\t0 , 'S W T1:1')"),
            std::string::npos)
      << files[0].text;
}

}  // namespace
}  // namespace tool_path_programs
