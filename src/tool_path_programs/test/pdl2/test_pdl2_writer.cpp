// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pdl2/pdl2.h"
#include "pdl2_reader/pdl2_conventions.h"
#include "scan_cell_common/errors/errors.h"
#include "tool_path_programs/read_back.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;

Move line_to(const Pdl2Numbers& numbers, double speed = 0.05, double zone = 0) {
  Move move;
  move.pose = pdl2_pose(numbers);
  move.speed = speed;
  move.zone = zone;
  return move;
}

Program program_of(std::vector<Step> steps) {
  Program program;
  program.name = "PART_7";
  program.frames = {{{"tools.gun", {}}, {"", pdl2_pose({1000, 0, 500, 0, 0, 90})}}};
  program.steps = std::move(steps);
  return program;
}

/// The first file after its settings.
std::string moves(const Program& program) {
  const std::string text = write_checked(pdl2(), program, {}).files[0].text;
  const std::string last = "$SPD_OPT := SPD_LIN\r\n";
  return text.substr(text.find(last) + last.size());
}

std::string cure_of(const Program& program) {
  try {
    pdl2().write(program, {});
  } catch (const UnusableInput& error) {
    return error.what();
  }
  return "";
}

TEST(Pdl2Writer, SaysFramesSpeedsZonesAndPosesInTheControllersWords) {
  Move first = line_to({10, 20, 30, 0, 180, 0});
  first.kind = MotionKind::kJoint;
  Move arc = line_to({30, 20, 0, 0, 180, 0}, 0.0004);
  arc.kind = MotionKind::kCircular;
  arc.via = pdl2_pose({20, 30, 0, 0, 180, 0});
  EXPECT_EQ(moves(program_of({first, line_to({10, 20, 0, 0, 180, 0}, 0.0004, 0.0015), arc,
                              SetOutput{"5", true}})),
            "  $TOOL := gun\r\n"
            "  $UFRAME := POS(1000.0000, 0.0000, 500.0000, 0.00000, 0.00000, 90.00000, '')\r\n"
            "  MOVE JOINT TO POS(10.0000, 20.0000, 30.0000, 0.00000, 180.00000, 0.00000, '')"
            " WITH $PROG_SPD_OVR = 10\r\n"
            "  $LIN_SPD := 0.0004\r\n  $FLY_DIST := 1.5\r\n"
            "  MOVEFLY LINEAR TO POS(10.0000, 20.0000, 0.0000, 0.00000, 180.00000, 0.00000, '')"
            " ADVANCE\r\n"
            "  MOVE CIRCULAR TO POS(30.0000, 20.0000, 0.0000, 0.00000, 180.00000, 0.00000, '')"
            " VIA POS(20.0000, 30.0000, 0.0000, 0.00000, 180.00000, 0.00000, '')\r\n"
            "  $DOUT[5] := ON\r\nEND PART_7\r\n");
}

TEST(Pdl2Writer, CommentsCannotBecomeStatements) {
  Program program = program_of({line_to({0, 0, 0, 0, 0, 0})});
  program.comments = {"part 7\r\nMOVE TO {1}", std::string(300, 'x'), "it's"};
  const std::string text = write_checked(pdl2(), program, {}).files[0].text;
  EXPECT_NE(text.find("\r\n-- MOVE TO {1}\r\n"), std::string::npos);
}

TEST(Pdl2Writer, ALongProgramBecomesProgramsWhoseRoutinesTheMainOneCalls) {
  std::vector<Step> steps;
  for (int i = 0; i < 100; ++i) {
    steps.emplace_back(line_to({double(i), 0, 0, 0, 0, 0}, 0.01 + 0.001 * (i % 2)));
    if (i % 10 == 0) steps.emplace_back(SetOutput{"1", i % 20 == 0});
  }
  WriteSettings settings;
  settings.max_lines = 40;
  const WrittenProgram written = write_checked(pdl2(), program_of(steps), settings);
  EXPECT_GT(written.files.size(), 5u);
  EXPECT_EQ(written.files[1].name, "PART_7_1.pdl");
  EXPECT_NE(written.files[0].text.find("ROUTINE R_PART_7_1 EXPORTED FROM PART_7_1\r\n"),
            std::string::npos);
  EXPECT_NE(written.files[0].text.find("  R_PART_7_1\r\n  R_PART_7_2\r\n"), std::string::npos);
  for (const SourceFile& file : written.files)
    EXPECT_LE(std::count(file.text.begin(), file.text.end(), '\n'), 40);
  settings.max_lines = 15;
  EXPECT_THROW(pdl2().write(program_of(steps), settings), InvalidParameter);
  const std::vector<Step> many(6000, line_to({0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(pdl2().write(program_of(many), {}).files.size(), 3u);
}

TEST(Pdl2Writer, WhatTheLanguageCannotSayIsRefusedWithWaypointAndCure) {
  const auto with = [&](const std::function<void(Move&)>& change) {
    Move move = line_to({0, 0, 0, 0, 0, 0});
    change(move);
    return cure_of(program_of({line_to({0, 0, 0, 0, 0, 0}), move, SetOutput{"1", true}}));
  };
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos ? testing::AssertionSuccess()
                                                : testing::AssertionFailure() << text;
  };
  EXPECT_TRUE(has(with([](Move& m) { m.speed = 2e-8; }), "waypoint 2: 2e-08 m/s"));
  EXPECT_TRUE(has(with([](Move& m) { m.speed = 3.5; }), "3 m/s"));
  EXPECT_TRUE(has(with([](Move& m) { m.kind = MotionKind::kJoint, m.joint_speed = 0.125; }),
                  "whole percents"));
  EXPECT_TRUE(has(with([](Move& m) { m.kind = MotionKind::kJoint, m.zone = 0.001; }), "zone 0"));
  EXPECT_TRUE(has(with([](Move& m) { m.zone = 1e-9; }), "0 for a stop"));
  EXPECT_TRUE(has(with([](Move& m) { m.zone = 0.001; }), "it would switch early"));
  EXPECT_TRUE(has(with([](Move& m) {
                    m.pose = pdl2_pose({0, 0, 0, 0, 179.95, 0});
                  }),
                  "put a waypoint between"));
  EXPECT_TRUE(has(with([](Move& m) { m.pose.translation().x() = std::nan(""); }), "waypoint 2"));
  Program program = program_of({line_to({0, 0, 0, 0, 0, 0})});
  program.name = "7 part";
  EXPECT_TRUE(has(cure_of(program), "P7_part"));
  program.name = std::string(200, 'a');
  EXPECT_TRUE(has(cure_of(program), ": " + std::string(32, 'a')));
  EXPECT_TRUE(has(cure_of(program_of({line_to({0, 0, 0, 0, 0, 0}), SetOutput{"doTool", true}})),
                  "from 1 up"));
  program = program_of({line_to({0, 0, 0, 0, 0, 0})});
  program.frames[0].tool.name = "gun";
  EXPECT_TRUE(has(cure_of(program), "program.variable"));
  WriteSettings settings;
  settings.dialect = "c3g";
  EXPECT_THROW(pdl2().write(program_of({line_to({0, 0, 0, 0, 0, 0})}), settings), InvalidParameter);
  EXPECT_THROW(pdl2().write(program_of({}), {}), UnusableInput);
}

TEST(Pdl2Writer, FramesComeBackAndAnglesOfTheAxesToTheLastDigit) {
  Program program = program_of({JointMove{{0.1, -90, 1.0 / 3, 0, 45, 1e-7, 1000.5}},
                                line_to({0, 0, 0, 0, 0, 0}), line_to({0, 1, 0, 0, 0, 0})});
  program.frames.push_back({{"", pdl2_pose({0, 0, 200, 0, 90, 0})}, {"", {}}});
  std::get<Move>(program.steps[2]).frames = 1;
  write_checked(pdl2(), program, {});
  const ProgramText read = pdl2().read(pdl2().write(program, {}).files, {});
  ASSERT_EQ(read.program.frames.size(), 2u);
  EXPECT_EQ(read.program.frames[0].tool.name, "tools.gun");
  EXPECT_TRUE(read.program.frames[0].user.pose->isApprox(*program.frames[0].user.pose, 1e-9));
  EXPECT_TRUE(read.program.frames[1].tool.pose->isApprox(*program.frames[1].tool.pose, 1e-9));
}

TEST(Pdl2Writer, AHundredThousandWaypointsComeBack) {
  std::vector<Step> steps;
  for (int i = 0; i < 100000; ++i)
    steps.emplace_back(
        line_to({i * 0.37, 500 * std::sin(i * 0.01), -i * 0.001, 180 * std::sin(i * 0.003),
                 90 + 90 * std::cos(i * 0.0011), i * 0.01},
                0.01 + 1e-5 * (i % 7), 0.001 * (i % 3)));
  WriteSettings exact;
  exact.max_speed_change = 1e-9;
  for (const SourceFile& file : write_checked(pdl2(), program_of(steps), exact).files)
    EXPECT_LE(std::count(file.text.begin(), file.text.end(), '\n'), 5000);
}

}  // namespace
}  // namespace tool_path_programs
