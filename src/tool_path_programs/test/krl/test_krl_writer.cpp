// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>

#include "krl/krl.h"
#include "krl_values/krl_conventions.h"
#include "scan_cell_common/errors/errors.h"
#include "tool_path_programs/read_back.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;

Move line_to(const KrlNumbers& numbers, double speed = 0.05, double zone = 0) {
  Move move;
  move.pose = krl_pose(numbers);
  move.speed = speed;
  move.zone = zone;
  return move;
}

Program program_of(std::vector<Step> steps) {
  Program program;
  program.name = "PART_7";
  program.frames = {{{"3", {}}, {"", krl_pose({1000, 0, 500, 0, 0, 90})}}};
  program.steps = std::move(steps);
  return program;
}

std::vector<std::string> statements(const WrittenProgram& written) {
  std::vector<std::string> lines;
  for (const SourceFile& file : written.files) {
    std::size_t begin = 0;
    for (std::size_t end; (end = file.text.find("\r\n", begin)) != std::string::npos;
         begin = end + 2)
      lines.push_back(file.text.substr(begin, end - begin));
  }
  return lines;
}

/// The statements after the first motion.
std::vector<std::string> moves(const Program& program) {
  std::vector<std::string> lines = statements(write_checked(krl(), program, {}));
  lines.erase(lines.begin(), std::find(lines.begin(), lines.end(), "PTP $AXIS_ACT") + 1);
  return lines;
}

std::string cure_of(const Program& program, const WriteSettings& settings = {}) {
  try {
    krl().write(program, settings);
  } catch (const UnusableInput& error) {
    return error.thing() + ": " + error.value() + "; " + error.cure();
  }
  return "";
}

TEST(KrlWriter, SaysFramesSpeedsZonesAndPosesInTheControllersWords) {
  Move first = line_to({10, 20, 30, 0, 90, 0});
  first.kind = MotionKind::kJoint;
  const std::vector<std::string> expected = {
      "BAS (#TOOL,3 )",
      "$BASE={X 1000.0000,Y 0.0000,Z 500.0000,A 0.00000,B 0.00000,C 90.00000}",
      "BAS (#VEL_PTP,10 )",
      "PTP {X 10.0000,Y 20.0000,Z 30.0000,A 0.00000,B 90.00000,C 0.00000}",
      "$VEL.CP=0.0004",
      "$APO.CDIS=1.5",
      "LIN {X 10.0000,Y 20.0000,Z 0.0000,A 0.00000,B 90.00000,C 0.00000} C_DIS",
      "LIN {X -1.2346,Y 20.0000,Z 0.0000,A 0.00000,B 90.00000,C 0.00000}",
      "END"};
  EXPECT_EQ(moves(program_of({first, line_to({10, 20, 0, 0, 90, 0}, 0.0004, 0.0015),
                              line_to({-1.23456, 20, 0, 0, 90, 0}, 0.0004)})),
            expected);
}

TEST(KrlWriter, AnOutputSwitchesAtThePoseWhetherTheRobotStopsThereOrFliesBy) {
  const Move stop = line_to({0, 0, 0, 0, 0, 0});
  const Move fly = line_to({50, 0, 0, 0, 0, 0}, 0.05, 0.001);
  const Move end = line_to({90, 0, 0, 0, 0, 0});
  const auto lines = moves(program_of(
      {stop, SetOutput{"5", true}, fly, SetOutput{"5", false}, SetOutput{"6", true}, end}));
  const auto at = std::find(lines.begin(), lines.end(), "$OUT[5]=TRUE");
  ASSERT_NE(at, lines.end());
  EXPECT_EQ((at - 1)->substr(0, 5), "LIN {");
  const auto trigger =
      std::find(lines.begin(), lines.end(), "TRIGGER WHEN DISTANCE=0 DELAY=0 DO $OUT[5]=FALSE");
  ASSERT_NE(trigger, lines.end());
  EXPECT_EQ(*(trigger + 1), "TRIGGER WHEN DISTANCE=0 DELAY=0 DO $OUT[6]=TRUE");
  EXPECT_EQ((trigger + 2)->substr(0, 5), "LIN {");
}

TEST(KrlWriter, CommentsCannotBecomeStatements) {
  Program program = program_of({line_to({0, 0, 0, 0, 0, 0})});
  program.comments = {"part 7\r\nPTP {A1 90}", std::string(300, 'x')};
  const WrittenProgram written = write_checked(krl(), program, {});
  for (const std::string& line : statements(written))
    EXPECT_LE(line.size(), 130u);
  EXPECT_NE(written.files[0].text.find("\r\n; PTP {A1 90}\r\n"), std::string::npos);
}

TEST(KrlWriter, ALongProgramBecomesFilesThatTheMainOneCalls) {
  std::vector<Step> steps;
  for (int i = 0; i < 100; ++i) {
    steps.emplace_back(line_to({double(i), 0, 0, 0, 0, 0}, 0.01 + 0.001 * (i % 2), 0.0002));
    if (i % 10 == 0) steps.emplace_back(SetOutput{"1", i % 20 == 0});
  }
  WriteSettings settings;
  settings.max_lines = 40;
  const WrittenProgram written = write_checked(krl(), program_of(steps), settings);
  EXPECT_GT(written.files.size(), 5u);
  EXPECT_EQ(written.files[0].name, "PART_7.src");
  EXPECT_EQ(written.files[1].name, "PART_7_1.src");
  EXPECT_NE(written.files[0].text.find("PART_7_1( )\r\nPART_7_2( )\r\n"), std::string::npos);
  for (const SourceFile& file : written.files)
    EXPECT_LE(std::count(file.text.begin(), file.text.end(), '\n'), 40);
  settings.max_lines = 12;
  EXPECT_THROW(krl().write(program_of(steps), settings), InvalidParameter);
}

TEST(KrlWriter, TheDialectTellsHowLongAFileMayBe) {
  const std::vector<Step> steps(2000, line_to({0, 0, 0, 0, 0, 0}));
  WriteSettings krc2;
  krc2.dialect = "krc2";
  EXPECT_EQ(krl().write(program_of(steps), krc2).files.size(), 1u);
  EXPECT_EQ(krl().write(program_of(steps), {}).files.size(), 3u);
  krc2.dialect = "krc9";
  EXPECT_THROW(krl().write(program_of(steps), krc2), InvalidParameter);
}

TEST(KrlWriter, WhatTheLanguageCannotSayIsRefusedWithWaypointAndCure) {
  Program program = program_of({line_to({0, 0, 0, 0, 0, 0})});
  const auto with = [&](const std::function<void(Move&)>& change) {
    Move move = line_to({0, 0, 0, 0, 0, 0});
    change(move);
    return cure_of(program_of({line_to({0, 0, 0, 0, 0, 0}), move}));
  };
  EXPECT_NE(with([](Move& m) { m.speed = 2e-8; }).find("waypoint 2: 2e-08 m/s"), std::string::npos);
  EXPECT_NE(with([](Move& m) { m.speed = 3.5; }).find("3 m/s"), std::string::npos);
  EXPECT_NE(with([](Move& m) {
              m.kind = MotionKind::kJoint, m.joint_speed = 0.125;
            }).find("whole percents"),
            std::string::npos);
  EXPECT_NE(
      with([](Move& m) { m.kind = MotionKind::kJoint, m.joint_speed = 0.001; }).find("give that"),
      std::string::npos);
  EXPECT_NE(with([](Move& m) { m.kind = MotionKind::kJoint, m.zone = 0.001; }).find("zone 0"),
            std::string::npos);
  EXPECT_NE(with([](Move& m) { m.zone = 1e-9; }).find("0 for a stop"), std::string::npos);
  EXPECT_NE(with([](Move& m) {
              m.pose = krl_pose({0, 0, 0, 0, 0, 179.95});
            }).find("put a waypoint between"),
            std::string::npos);
  EXPECT_NE(with([](Move& m) { m.pose.translation().x() = std::nan(""); }).find("waypoint 2"),
            std::string::npos);
  EXPECT_NE(cure_of(program_of({[] {
              Move arc = line_to({0, 0, 0, 0, 0, 0});
              arc.kind = MotionKind::kCircular;
              arc.via = arc.pose;
              return arc;
            }()}))
                .find("come before it"),
            std::string::npos);
  program.name = "part 7";
  EXPECT_NE(cure_of(program).find("part_7"), std::string::npos);
  program.name = std::string(200, 'a');
  EXPECT_NE(cure_of(program).find(": " + std::string(24, 'a')), std::string::npos);
  program = program_of({line_to({0, 0, 0, 0, 0, 0}), SetOutput{"doTool", true}});
  EXPECT_NE(cure_of(program).find("1 to 8192"), std::string::npos);
  program = program_of({line_to({0, 0, 0, 0, 0, 0})});
  program.frames[0].tool.name = "gripper";
  EXPECT_NE(cure_of(program).find("0 to 128"), std::string::npos);
  EXPECT_THROW(krl().write(program_of({}), {}), UnusableInput);
}

TEST(KrlWriter, ArcsAndAnglesOfTheAxesComeBack) {
  Move arc = line_to({20, 0, 0, 10, 20, 30}, 0.03, 0.0005);
  arc.kind = MotionKind::kCircular;
  arc.via = krl_pose({10, 10, 0, 1, 2, 3});
  write_checked(krl(),
                program_of({JointMove{{0.1, -90, 1.0 / 3, 0, 45, 1e-7, 1000.5}},
                            line_to({0, 0, 0, 0, 0, 0}), arc}),
                {});
}

TEST(KrlWriter, FramesComeBackAndChangeWhereMovesSay) {
  Program program = program_of({line_to({0, 0, 0, 0, 0, 0}), line_to({0, 1, 0, 0, 0, 0})});
  program.frames.push_back({{"", krl_pose({0, 0, 200, 0, 90, 0})}, {"BASE_DATA[12]", {}}});
  std::get<Move>(program.steps[1]).frames = 1;
  const ProgramText read = krl().read(krl().write(program, {}).files, {});
  ASSERT_EQ(read.program.frames.size(), 2u);
  EXPECT_EQ(read.program.frames[0].tool.name, "TOOL_DATA[3]");
  EXPECT_TRUE(read.program.frames[0].user.pose->isApprox(*program.frames[0].user.pose, 1e-9));
  EXPECT_TRUE(read.program.frames[1].tool.pose->isApprox(*program.frames[1].tool.pose, 1e-9));
  EXPECT_EQ(read.program.frames[1].user.name, "BASE_DATA[12]");
  EXPECT_EQ(std::get<Move>(read.program.steps[1]).frames, 1u);
}

TEST(KrlWriter, ALocaleWithDecimalCommasChangesNothing) {
  const Program program = program_of({line_to({0.5, 0, 0, 1.5, 0, 0}, 0.0155)});
  const std::string text = krl().write(program, {}).files[0].text;
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) GTEST_SKIP() << "there is no such locale";
  EXPECT_EQ(write_checked(krl(), program, {}).files[0].text, text);
  std::setlocale(LC_ALL, "C");
}

TEST(KrlWriter, AHundredThousandWaypointsComeBack) {
  std::vector<Step> steps;
  for (int i = 0; i < 100000; ++i)
    steps.emplace_back(line_to({i * 0.37, 500 * std::sin(i * 0.01), -i * 0.001,
                                180 * std::sin(i * 0.003), 90 * std::cos(i * 0.0011), i * 0.01},
                               0.01 + 1e-5 * (i % 7), 0.001 * (i % 3)));
  WriteSettings exact;
  exact.max_speed_change = 1e-9;
  for (const SourceFile& file : write_checked(krl(), program_of(steps), exact).files)
    EXPECT_LE(std::count(file.text.begin(), file.text.end(), '\n'), 1400);
}

}  // namespace
}  // namespace tool_path_programs
