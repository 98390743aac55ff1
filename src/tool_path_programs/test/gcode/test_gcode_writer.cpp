// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "gcode/gcode.h"
#include "scan_cell_common/errors/errors.h"
#include "tool_path_programs/read_back.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

/// Moves 10 mm apart, the first by the joints, the tool pointing down and increasingly tilted.
Program example(std::size_t moves, double tilt) {
  Program program;
  program.name = "ADAPTED";
  program.comments = {"part (7)"};
  program.frames = {{{"3", {}}, {"G55", {}}}};
  for (std::size_t i = 0; i < moves; ++i) {
    Move move;
    move.kind = i == 0 ? MotionKind::kJoint : MotionKind::kLinear;
    move.joint_speed = 1;
    move.pose.translation() = Eigen::Vector3d(0.01 * static_cast<double>(i), 0.1, -0.2);
    move.pose.rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
    move.pose.rotate(Eigen::AngleAxisd(tilt * static_cast<double>(i), Eigen::Vector3d::UnitY()));
    move.zone = i < 2 || i + 1 == moves ? 0 : 0.002;
    program.steps.emplace_back(move);
    if (i == 1) program.steps.emplace_back(SetOutput{"4", true});
  }
  program.steps.emplace_back(SetOutput{"4", false});
  return program;
}

Move& move_of(Program& program, std::size_t step) {
  return std::get<Move>(program.steps.at(step));
}

std::string written(const Program& program, const std::string& dialect) {
  WriteSettings settings;
  settings.dialect = dialect;
  return write_checked(gcode(), program, settings).files.at(0).text;
}

std::string fault_of(const Program& program, const std::string& dialect) {
  try {
    written(program, dialect);
  } catch (const UnusableInput& error) {
    return error.thing() + ": " + error.value();
  }
  return "";
}

TEST(GcodeWriter, WritesModesFramesMovesAndOutputs) {
  EXPECT_EQ(written(example(4, 0), "xyz"),
            "; ADAPTED\n; part (7)\nG21 G17 G90 G94 G40\nG55\nT3 M6\nG43 H3\nG61.1\n"
            "G0 X0.0000 Y100.0000 Z-200.0000\nG1 X10.0000 Y100.0000 Z-200.0000 F3000\nM64 P4\n"
            "G64 P2\nG1 X20.0000 Y100.0000 Z-200.0000\nG61.1\nG1 X30.0000 Y100.0000 Z-200.0000\n"
            "M65 P4\nM2\n");
}

TEST(GcodeWriter, EverythingComesBackInEachDialect) {
  for (const char* dialect : {"", "xyzabc", "xyzac", "xyzbc"})
    EXPECT_NO_THROW(written(example(400, 0.01), dialect)) << dialect;
}

TEST(GcodeWriter, ToolsDirectionComesBackFromMachines) {
  const Program program = example(300, 0.01);
  for (const char* dialect : {"xyzac", "xyzbc"}) {
    ReadSettings settings;
    settings.dialect = dialect;
    const ProgramText read = gcode().read({{"part.ngc", written(program, dialect)}}, settings);
    const auto meant = moves_of(program);
    const auto got = moves_of(read.program);
    ASSERT_EQ(got.size(), meant.size());
    for (std::size_t i = 0; i < got.size(); ++i)
      EXPECT_LT((got[i]->pose.linear().col(2) - meant[i]->pose.linear().col(2)).norm(),
                0.001 * M_PI / 180);
  }
}

TEST(GcodeWriter, RefusesWhatItCannotSayAndNamesTheWaypoint) {
  const auto fault_after = [](const std::function<void(Program&)>& change,
                              const std::string& dialect = "xyzabc") {
    Program program = example(4, 0);
    change(program);
    return fault_of(program, dialect);
  };
  EXPECT_EQ(fault_after([](Program& p) { move_of(p, 0).joint_speed = 0.1; }),
            "program ADAPTED, waypoint 1: a joint move at 10 % of the axes' speed");
  EXPECT_EQ(fault_after([](Program& p) { move_of(p, 1).speed = 1e-9; }),
            "program ADAPTED, waypoint 2: speed 1e-09 m/s");
  EXPECT_EQ(fault_after([](Program& p) { move_of(p, 4).zone = 1e-3; }),
            "program ADAPTED, waypoint 4: a zone where output 4 switches");
  EXPECT_EQ(fault_after([](Program& p) {
              move_of(p, 3).pose.rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
            }),
            "program ADAPTED, waypoint 3: turned by 180.0 degrees from the one before");
  EXPECT_EQ(fault_after(
                [](Program& p) {
                  move_of(p, 3).pose.rotate(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX()));
                },
                "xyz"),
            "program ADAPTED, waypoint 3: turned by 0.573 degrees from the one before");
  EXPECT_EQ(fault_after([](Program& p) { p.frames[0].user.name = "table"; }),
            "user frame table: not a G-code coordinate system");
  EXPECT_EQ(fault_after([](Program& p) {
              p.frames[0].user = {"", Eigen::Isometry3d::Identity()};
            }),
            "user frame: its pose cannot be written into the program");
  EXPECT_EQ(fault_after([](Program& p) { p.frames[0].tool.name = "torch"; }),
            "tool torch: not a tool number");
  EXPECT_EQ(fault_after([](Program& p) {
              p.steps.emplace_back(SetOutput{"doTool", true});
            }),
            "output doTool: not a G-code output");
}

TEST(GcodeWriter, AxesThatTurnOverAreRefused) {
  Program program = example(3, 0);
  move_of(program, 1).pose.rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()));
  move_of(program, 3).pose.rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()));
  EXPECT_EQ(fault_of(program, "xyzac"), "");  // C by a quarter
  program = example(3, 0);
  move_of(program, 1).pose.rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()));
  move_of(program, 3).pose.rotate(Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitX()));
  EXPECT_EQ(fault_of(program, "xyzac"), "");  // A goes through, C stays
}

}  // namespace
}  // namespace tool_path_programs
