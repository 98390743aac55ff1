// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tool_path_programs/program_path.h"
#include "urscript/urscript.h"

namespace tool_path_programs {
namespace {

// As written by somebody else: odd blanks, tabs, CR LF, comments, signs, an arc over two lines, a
// vector longer than half a turn.
const std::string kOdd =
    "def  seam( ) :\r\n"
    "\t# from  the pendant, 3 mm above\r\n"
    "\tset_tcp( p[0,0, .15 ,0,0,0] )   # torch\r\n"
    "\tglobal A_p=p[ .5,-.1 ,+.2000 , 3.9322, 1.6518, 1.6554 ]  # first\r\n"
    "\tmovel( A_p ,v = .02 )\r\n"
    "\tif get_digital_in( 3 ) == False :\r\n"
    "\t\tpopup(\"p[1, 2, 3] # no comment\")\r\n"
    "\tend\r\n"
    "\tset_digital_out( 1 ,True )\r\n"
    "\tmovec( p[.55, -.1, .21, 0, 3.1, 0],   # via\r\n"
    "\t       p[.6, -1e-1, .2, 0, 3.1, 0], 1.2, .02 )\r\n"
    "\tsync( )\r\n"
    "\tset_digital_out( 1 ,False )\r\n"
    "\tmovel( A_p )\r\n"
    "end\r\n";

std::vector<Eigen::Isometry3d> moved_poses(const ProgramText& text,
                                           const Eigen::Isometry3d& motion) {
  std::vector<Eigen::Isometry3d> poses;
  for (const PoseText& pose : text.poses)
    poses.push_back(motion * pose.pose);
  return poses;
}

ProgramText odd_program() {
  return urscript().read({{"seam.script", kOdd}}, {});
}

TEST(UrscriptRewrite, TheSamePosesChangeNoByte) {
  const ProgramText text = odd_program();
  ASSERT_EQ(text.poses.size(), 3u);
  const auto same = moved_poses(text, Eigen::Isometry3d::Identity());
  EXPECT_EQ(with_poses(urscript(), text, {}, same).at(0).text, kOdd);
}

TEST(UrscriptRewrite, MovedPosesChangeTheirNumbersAlone) {
  const ProgramText text = odd_program();
  const Eigen::Isometry3d up(Eigen::Translation3d(0.01, 0, -0.0002));
  std::string wanted = kOdd;
  const auto replace = [&](const std::string& from, const std::string& to) {
    wanted.replace(wanted.find(from), from.size(), to);
  };
  replace("[ .5,-.1 ,+.2000 ,", "[ 0.5100000,-.1 ,0.1998000 ,");
  replace("p[.55, -.1, .21,", "p[0.5600000, -.1, 0.2098000,");
  replace("p[.6, -1e-1, .2,", "p[0.6100000, -1e-1, 0.1998000,");
  EXPECT_EQ(with_poses(urscript(), text, {}, moved_poses(text, up)).at(0).text, wanted);
}

TEST(UrscriptRewrite, TurnedPosesComeBackAndVectorsStayOnTheirSide) {
  const ProgramText text = odd_program();
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d(0.6, 0, 0.8)));
  const auto poses = moved_poses(text, turn);
  const auto files = with_poses(urscript(), text, {}, poses);
  const ProgramText again = urscript().read(files, {});
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_LT((again.poses[i].pose.translation() - poses[i].translation()).norm(), 1e-6);
    EXPECT_LT(Eigen::Quaterniond(again.poses[i].pose.linear())
                  .angularDistance(Eigen::Quaterniond(poses[i].linear())),
              1e-5);
  }
  const std::size_t first = files[0].text.find("A_p=p[");
  double vector[3];
  ASSERT_EQ(std::sscanf(files[0].text.c_str() + first, "A_p=p[ %*f,%*f ,%*f , %lf, %lf, %lf",
                        vector, vector + 1, vector + 2),
            3);
  EXPECT_GT(std::hypot(vector[0], vector[1], vector[2]), M_PI + 1);
}

TEST(UrscriptRewrite, LongNumbersKeepTheirDigits) {
  const ProgramText text =
      urscript().read({{"a.script", "movel(p[0.433025361705, 0, 0, 0, 0, 0])\n"}}, {});
  const Eigen::Isometry3d along(Eigen::Translation3d(0.1, 0, 0));
  EXPECT_EQ(with_poses(urscript(), text, {}, moved_poses(text, along)).at(0).text,
            "movel(p[0.533025361705, 0, 0, 0, 0, 0])\n");
}

}  // namespace
}  // namespace tool_path_programs
