// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "fanuc_examples.h"
#include "tool_path_programs/program_path.h"

namespace tool_path_programs {
namespace {

// As saved by a controller and changed by people: tabs, CR LF, remarks, welding, other groups.
std::string program_text() {
  std::string text = fanuc_program(
      "   1:  !taught on 3 May, don't touch ;\n   2:  UFRAME_NUM=2 ;\n   3:\tUTOOL_NUM=1 ;\n"
      "   4:J P[3:home] 50% CNT100    ;\n   5:  CALL CLEAN(3) ;\n   6:L P[1] 200mm/sec FINE    ;\n"
      "   7:  Weld Start E1[1,1] ;\n   8:  Weave Sine[1] ;\n"
      "   9:L P[2:it's here] 42cm/min CNT100 COORD PTH    ;\n  10:  Weave End ;\n"
      "  11:  WAIT   1.50(sec) ;\n  12:  DO[3]=OFF ;\n");
  std::string windows;
  for (const char character : text)
    windows += character == '\n' ? std::string("\r\n") : std::string(1, character);
  return windows;
}

ReadSettings known() {
  ReadSettings settings;
  settings.calls_without_motion = {"CLEAN"};
  return settings;
}

std::string without_digits(const std::string& text) {
  std::string rest;
  for (const char character : text)
    if (std::string("0123456789.-").find(character) == std::string::npos) rest += character;
  return rest;
}

std::vector<Eigen::Isometry3d> poses_in(const ProgramText& text) {
  std::vector<Eigen::Isometry3d> poses;
  for (const PoseText& pose : text.poses)
    poses.push_back(pose.pose);
  return poses;
}

TEST(FanucEdits, TheSamePosesChangeNothing) {
  const ProgramText text = fanuc().read({{"part.ls", program_text()}}, known());
  ASSERT_EQ(text.poses.size(), 2u);
  EXPECT_TRUE(fanuc().edits(text, poses_in(text)).empty());
}

TEST(FanucEdits, OtherPosesChangeTheirNumbersAlone) {
  const ProgramText text = fanuc().read({{"part.ls", program_text()}}, known());
  std::vector<Eigen::Isometry3d> poses = poses_in(text);
  poses[0].translation() += Eigen::Vector3d(0.00123456, -0.0021, 0);
  poses[1].translation() += Eigen::Vector3d(0, 0, 0.1);
  for (Eigen::Isometry3d& pose : poses)
    pose.linear() =
        Eigen::AngleAxisd(0.01, Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix() * pose.linear();
  const auto files = with_poses(fanuc(), text, known(), poses);
  const std::string& now = files.front().text;
  std::string before = program_text();
  before.replace(before.find("3.0E2"), 5, "3.02");  // numbers are written without exponents
  EXPECT_EQ(without_digits(now), without_digits(before));
  const ProgramText again = fanuc().read(files, known());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_LT((again.poses[i].pose.translation() - poses[i].translation()).norm(), 1e-6);
    EXPECT_LT(Eigen::Quaterniond(again.poses[i].pose.linear())
                  .angularDistance(Eigen::Quaterniond(poses[i].linear())),
              0.001 * M_PI / 180);
  }
  EXPECT_EQ(now.substr(0, now.find("/POS")), before.substr(0, before.find("/POS")));
  EXPECT_EQ(now.substr(now.find("P[3]{")), before.substr(before.find("P[3]{")));
  EXPECT_NE(now.find("\tX =   101.235  mm,\tY =   197.900  mm,\tZ =   300.000  mm,"),
            std::string::npos);
  EXPECT_NE(now.find("\tX = 110 mm, Y = 200.0 mm,\tZ = 400.000  mm"), std::string::npos);
}

}  // namespace
}  // namespace tool_path_programs
