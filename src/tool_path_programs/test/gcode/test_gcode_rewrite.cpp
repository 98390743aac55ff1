// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "gcode/gcode.h"
#include "scan_cell_common/errors/errors.h"
#include "tool_path_programs/program_path.h"

namespace tool_path_programs {
namespace {

/// The program with all poses moved.
std::string moved(const std::string& program, const Eigen::Isometry3d& motion) {
  const ProgramText text = gcode().read({{"part.nc", program}}, {});
  std::vector<Eigen::Isometry3d> poses;
  for (const PoseText& pose : text.poses)
    poses.push_back(motion * pose.pose);
  return with_poses(gcode(), text, {}, poses).at(0).text;
}

Eigen::Isometry3d by(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

const std::string kOdd =
    "%\r\nN10\tg21 G90 (X1 Y2)\r\ng0x 0 Y0\r\nZ 5.\t; Z7\r\n\r\nN40 G1 X+10.25 F100 M3\r\n"
    "Y-.5 S200\r\nM64 P1\r\nG4 P1\r\nX20\r\nM5 (off)\r\n";

TEST(GcodeRewrite, TheSamePosesChangeNoByte) {
  EXPECT_EQ(moved(kOdd, Eigen::Isometry3d::Identity()), kOdd);
  const std::string arcs = "G0 X0 Y0 Z0\nG2 X10 Y0 R5 F100\nG1 X20\n";
  EXPECT_EQ(moved(arcs, Eigen::Isometry3d::Identity()), arcs);
  const std::string lock = "G0 X0 Y0 Z0 A10 B90 C30\nG1 X1 F100\nA400 B-90 C-700\n";
  EXPECT_EQ(moved(lock, Eigen::Isometry3d::Identity()), lock);
}

TEST(GcodeRewrite, AWordIsPutInWhereAnAxisWasLeftElsewhere) {
  // the line with only Z gets X and Y; from then on Z is where it was left
  EXPECT_EQ(moved(kOdd, by(0.001, 0, -0.002)),
            "%\r\nN10\tg21 G90 (X1 Y2)\r\ng0x 0 Y0\r\nZ 3.0000 X1.0000\t; Z7\r\n\r\n"
            "N40 G1 X11.2500 F100 M3\r\nY-.5 S200\r\nM64 P1\r\nG4 P1\r\nX21.0000\r\nM5 (off)\r\n");
}

TEST(GcodeRewrite, EachPoseGetsItsOwnAxes) {
  const ProgramText text = gcode().read({{"part.nc", "G0 X0 Y0 Z1\nG1 X1 F60\nX2\nX3\n"}}, {});
  std::vector<Eigen::Isometry3d> poses;
  for (const PoseText& pose : text.poses)
    poses.push_back(pose.pose);
  poses[1] = by(0, 0.0005, 0) * poses[1];
  EXPECT_EQ(with_poses(gcode(), text, {}, poses).at(0).text,
            "G0 X0 Y0 Z1\nG1 X1 Y0.5000 F60\nX2 Y0.0000\nX3\n");
}

TEST(GcodeRewrite, InchesStayInches) {
  EXPECT_EQ(moved("G20\nG0 X1 Y0 Z0\nG1 X2.0000000 F10\n", by(0.0254, 0, 0)),
            "G20\nG0 X2.000000 Y0 Z0\nG1 X3.0000000 F10\n");
}

TEST(GcodeRewrite, RotaryAxesFollowTheToolsDirection) {
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.rotate(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
  EXPECT_EQ(moved("G0 X10 Y0 Z0 A30 C350\nG1 X20 F60\n", turn),
            "G0 X0.0000 Y10.0000 Z0 A30 C440.00000\nG1 X0.0000 Y20.0000 F60\n");
  EXPECT_EQ(moved("G0 X10 Y0 Z0 A5 B30 C0\nG1 X20 F60\n", turn),
            "G0 X0.0000 Y10.0000 Z0 A5 B30 C90.00000\nG1 X0.0000 Y20.0000 F60\n");
}

TEST(GcodeRewrite, ArcsThatAreToMoveMustBecomeLinesBefore) {
  EXPECT_THROW(moved("G0 X0 Y0 Z0\nG2 X10 Y0 R5 F100\n", by(0.001, 0, 0)),
               scan_cell_common::UnusableInput);
}

}  // namespace
}  // namespace tool_path_programs
