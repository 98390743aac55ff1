// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "krl/krl.h"
#include "krl_values/krl_conventions.h"
#include "tool_path_programs/program_path.h"

namespace tool_path_programs {
namespace {

const char* const kSource =
    "&ACCESS RVP\r\n&PARAM TEMPLATE = C:\\KRC\\Roboter\\Template\\vorgabe\r\nDEF rim ( )\r\n"
    "; keep: LIN {X 1,Y 2}\r\n\tBAS (#INITMOV,0 )\r\n$VEL.CP=0.02 ; m/s\r\n"
    "PTP   {X 100.5,  Y -20 ,Z 3.123456,A 0,B 90.0,\tC 0 , S 'B010', T 35}\t; approach\r\n"
    "glue(TRUE) \r\n$OUT[3]=TRUE\r\nLIN XP1 C_DIS\r\nWAIT SEC 0.5\r\nlin {x 1.5e2,y 0,z 0}\r\n"
    "CIRC XP2 , {X 200,Y 0,Z 0,A 0,B 90,C 0,E1 15} C_DIS\r\nLIN XP1\r\n$OUT[3]=FALSE\r\nEND\r\n";
const char* const kData =
    "DEFDAT RIM\r\nDECL E6POS XP1={X 120.00,Y 0,Z 0,A 0,B 90,C 0,S 2,T 10,E1 0.0} ; one\r\n"
    "DECL FDAT FP1={TOOL_NO 1,BASE_NO 1}\r\nDECL POS XP2={X 170,Y 10,Z 0,A 0,B 90,C "
    "0}\r\nENDDAT\r\n";

ReadSettings known() {
  ReadSettings settings;
  settings.calls_without_motion = {"glue"};
  return settings;
}

ProgramText rim() {
  return krl().read({{"rim.src", kSource}, {"rim.dat", kData}}, known());
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

TEST(KrlRewrite, TheSamePosesChangeNoByte) {
  const ProgramText text = rim();
  EXPECT_EQ(text.poses.size(), 5u);
  const auto files = with_poses(krl(), text, known(), poses_of(text));
  EXPECT_EQ(files[0].text, kSource);
  EXPECT_EQ(files[1].text, kData);
}

TEST(KrlRewrite, OtherPosesChangeTheirNumbersAlone) {
  const ProgramText text = rim();
  std::vector<Eigen::Isometry3d> poses = poses_of(text);
  const Eigen::Isometry3d moved = Eigen::Translation3d(0.1, -0.02, 0.003) *
                                  Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 2) / 3);
  for (Eigen::Isometry3d& pose : poses)
    pose = moved * pose;
  const auto files = with_poses(krl(), text, known(), poses);
  EXPECT_EQ(without_numbers(files[0].text), without_numbers(kSource));
  EXPECT_EQ(without_numbers(files[1].text), without_numbers(kData));
  for (const char* kept :
       {"S 'B010', T 35}\t; approach\r\n", "; keep: LIN {X 1,Y 2}\r\n", "$VEL.CP=0.02 ; m/s\r\n",
        ",E1 15} C_DIS\r\n", "glue(TRUE) \r\n", "WAIT SEC 0.5\r\n"})
    EXPECT_NE(files[0].text.find(kept), std::string::npos) << kept;
  EXPECT_NE(files[1].text.find(",S 2,T 10,E1 0.0} ; one\r\n"), std::string::npos);
}

TEST(KrlRewrite, NumbersKeepTheirDigitsAndHaveEnoughOfThem) {
  ProgramText text = rim();
  std::vector<Eigen::Isometry3d> poses = poses_of(text);
  poses[0].translation() += Eigen::Vector3d(0.001, 0.0001, 0.0000012);
  const auto files = with_poses(krl(), text, known(), poses);
  EXPECT_NE(files[0].text.find("{X 101.5000,  Y -19.9000 ,Z 3.124656,A 0,B 90.0,\tC 0 ,"),
            std::string::npos)
      << files[0].text;
}

TEST(KrlRewrite, WhatALiteralLeavesOutIsPutInOnlyWhereItDiffersFromThePoseBefore) {
  const std::vector<SourceFile> files = {
      {"a.src", "DEF a()\nLIN {X 0,Y 0,Z 0,A 10,B 0,C 0}\nLIN {X 5}\nLIN {Z 7,B 3}\nEND\n"}};
  const ProgramText text = krl().read(files, {});
  std::vector<Eigen::Isometry3d> poses = poses_of(text);
  for (Eigen::Isometry3d& pose : poses)
    pose.translation().y() += 0.001;
  EXPECT_EQ(with_poses(krl(), text, {}, poses)[0].text,
            "DEF a()\nLIN {X 0,Y 1.0000,Z 0,A 10,B 0,C 0}\nLIN {X 5}\nLIN {Z 7,B 3}\nEND\n");
  poses = poses_of(text);
  poses[1].translation().y() += 0.001;
  EXPECT_EQ(with_poses(krl(), text, {}, poses)[0].text,
            "DEF a()\nLIN {X 0,Y 0,Z 0,A 10,B 0,C 0}\nLIN {X 5,Y 1.0000}\n"
            "LIN {Z 7,B 3,Y 0.0000}\nEND\n");
  poses = poses_of(text);
  poses[0].rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()));
  poses[1] = Eigen::Translation3d(0.005, 0, 0) * Eigen::Isometry3d(poses[0].linear());
  const std::string turned = with_poses(krl(), text, {}, poses)[0].text;
  EXPECT_NE(turned.find("LIN {X 5}\nLIN {Z 7,B 3.00000,A 10.00000,C "), std::string::npos)
      << turned;
}

}  // namespace
}  // namespace tool_path_programs
