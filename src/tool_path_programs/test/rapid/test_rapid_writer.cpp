// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <clocale>
#include <random>

#include "rapid/rapid_examples.h"
#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;

WrittenProgram written(const Program& program, const WriteSettings& settings = {}) {
  return write_checked(rapid(), program, settings);
}

std::string text_of(const Program& program) {
  return written(program).files.front().text;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string fault_of(const Program& program, const WriteSettings& settings = {}) {
  try {
    written(program, settings);
  } catch (const scan_cell_common::Error& error) {
    return error.what();
  }
  return "";
}

TEST(RapidWriter, SaysToolWorkObjectSpeedsZonesAndOutputs) {
  Program program = empty_rapid_program();
  program.comments = {"part 17", "two\nlines"};
  Move approach = rapid_move(0, 0, 0.1, 0.25, 0);
  approach.kind = MotionKind::kJoint;
  program.steps = {approach,
                   rapid_move(0, 0, 0, 0.0123, 0),
                   SetOutput{"doGun", true},
                   rapid_move(0.1, 0, 0),
                   rapid_move(0.2, 0, 0, 0.05, 0.0025),
                   SetOutput{"doGun", false}};
  const std::string text = text_of(program);
  EXPECT_TRUE(has(text, "  ! part 17\r\n  ! two\r\n  ! lines\r\n"));
  EXPECT_TRUE(has(text, "tooldata tGun:=[TRUE,[[10.0000,20.0000,300.0000],[1.00000000,"));
  EXPECT_TRUE(has(text, "wobjdata wPart:=[FALSE,TRUE,\"\",[[1200.0000,-400.0000,500.0000],"));
  EXPECT_TRUE(has(text, ",v500,fine,tGun\\WObj:=wPart;\r\n"));
  EXPECT_TRUE(has(text, ",[12.3,500,5000,1000],fine,tGun\\WObj:=wPart;\r\n    SetDO doGun,1;"));
  EXPECT_TRUE(has(text, ",v50,z1,tGun\\WObj:=wPart;"));
  EXPECT_TRUE(has(text, "MoveLDO [["));
  EXPECT_TRUE(has(text, ",v50,[FALSE,2.5,3.75,3.75,0.375,3.75,0.375],tGun\\WObj:=wPart,doGun,0;"));
}

// RAPID reference, data type orient: a tool whose x' is -z, y' is y and z' is x has 0.707 0 0.707
// 0; one that is turned by 30 degrees about y has 0.965926 0 0.258819 0.
TEST(RapidWriter, QuaternionsAreThoseOfTheReference) {
  Program program = empty_rapid_program();
  Move move = rapid_move(0, 0, 0);
  move.pose.linear() << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  program.steps = {move};
  EXPECT_TRUE(has(text_of(program), "[0.70710678,0.00000000,0.70710678,0.00000000]"));
  move.pose.linear() << std::sqrt(0.75), 0, 0.5, 0, 1, 0, -0.5, 0, std::sqrt(0.75);
  program.steps = {move};
  EXPECT_TRUE(has(text_of(program), "[0.96592583,0.00000000,0.25881905,0.00000000]"));
}

TEST(RapidWriter, HundredThousandWaypointsComeBack) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  Program program = empty_rapid_program();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  for (int i = 0; i < 100000; ++i) {
    Move move =
        rapid_move(2 * number(random), 2 * number(random), 2 * number(random),
                   0.1 + 0.09 * number(random), i % 3 == 0 ? 0 : 0.002 + 0.001 * number(random));
    turn =
        turn * Eigen::AngleAxisd(number(random),
                                 Eigen::Vector3d(number(random), number(random), 1.1).normalized());
    move.pose.linear() = turn.normalized().toRotationMatrix();
    program.steps.emplace_back(move);
    if (i % 1000 == 0) program.steps.emplace_back(SetOutput{"doGun", i % 2000 == 0});
  }
  const WrittenProgram result = written(program);
  EXPECT_EQ(result.files.size(), 22u);
  for (const SourceFile& file : result.files)
    EXPECT_LE(std::count(file.text.begin(), file.text.end(), '\n'), 5000);
}

TEST(RapidWriter, TurnsByHalfAndNextToItComeBack) {
  for (const double angle : {M_PI, M_PI - 1e-9, -M_PI + 1e-6, 1e-9}) {
    Program program = empty_rapid_program();
    Move move = rapid_move(0, 0, 0);
    move.pose.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -2) / 3).toRotationMatrix();
    program.steps = {move};
    EXPECT_EQ(fault_of(program), "");
  }
}

TEST(RapidWriter, LongProgramsAreSplitAndReadInTheirOrder) {
  Program program = empty_rapid_program();
  for (int i = 0; i < 50; ++i)
    program.steps.emplace_back(rapid_move(0.01 * i, 0, 0));
  WriteSettings settings;
  settings.max_lines = 20;
  const WrittenProgram result = written(program, settings);
  ASSERT_EQ(result.files.size(), 5u);
  EXPECT_TRUE(has(result.files[0].text, "    PART_1;\r\n    PART_2;\r\n    PART_3;\r\n"));
  EXPECT_EQ(result.files[4].name, "PART_4.mod");
}

TEST(RapidWriter, WhatItCannotSayIsRefusedWithTheWaypointAndACure) {
  const auto with = [](const Step& step) {
    Program program = empty_rapid_program();
    program.steps = {rapid_move(0, 0, 0), step};
    return program;
  };
  EXPECT_EQ(fault_of(with(rapid_move(0, 0, 0, 4e-8))),
            "RAPID, waypoint 2: speed 4e-05 mm/s, which would become 0 mm/s; give a greater speed, "
            "or a greater max_speed_change");
  EXPECT_EQ(fault_of(with(rapid_move(0, 0, 0, 8))),
            "RAPID, waypoint 2: speed 8000 mm/s; give at most 7000 mm/s, the fastest that RAPID "
            "has a name for");
  EXPECT_EQ(fault_of(with(rapid_move(0, 0, 0, 0.05, 1e-9))),
            "RAPID, waypoint 2: zone 1e-06 mm; give 0, where the tool stops, or a greater one");
  Move turned = rapid_move(0, 0, 0);
  turned.pose.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  EXPECT_TRUE(has(fault_of(with(turned)), "waypoint 2: turned by 180 degrees"));
  Move not_finite = rapid_move(NAN, 0, 0);
  EXPECT_TRUE(has(fault_of(with(not_finite)), "waypoint 2: its pose is not finite"));
}

TEST(RapidWriter, NamesThatWouldNotDoAreRefusedWithOneThatWould) {
  Program program = empty_rapid_program();
  program.steps = {rapid_move(0, 0, 0, 0.05, 0)};
  const auto fault_of_name = [&](const std::string& name) {
    Program named = program;
    named.name = name;
    return fault_of(named);
  };
  EXPECT_TRUE(has(fault_of_name("part 17"), "name it part_17, for example"));
  EXPECT_TRUE(has(fault_of_name("17"), "name it p_17, for example"));
  EXPECT_TRUE(has(fault_of_name("While"), "a word of RAPID itself; name it p_While"));
  EXPECT_TRUE(
      has(fault_of_name(std::string(200, 'x')), "200 characters of at most 23; name it xx"));
  EXPECT_TRUE(has(fault_of_name(""), "no name"));
  program.steps.emplace_back(SetOutput{"5", true});
  EXPECT_TRUE(has(fault_of(program), "output '5'"));
}

TEST(RapidWriter, AToolThatNobodyNamesIsRefused) {
  Program program = empty_rapid_program();
  program.steps = {rapid_move(0, 0, 0)};
  program.frames = {{}};
  EXPECT_TRUE(has(fault_of(program), "give its name on the controller, or a cell file"));
  program.frames[0].tool.name = "tGun";
  EXPECT_TRUE(has(text_of(program), ",v50,z1,tGun;"));
  program.frames[0].tool = {"tool0", Eigen::Isometry3d(Eigen::Translation3d(0, 0, 1))};
  EXPECT_TRUE(has(fault_of(program), "tool0: predefined by RAPID"));
}

TEST(RapidWriter, QuarterTurnsOfTheAxesBecomeTheConfiguration) {
  Program program = empty_rapid_program();
  Move move = rapid_move(0, 0, 0);
  move.joints = JointAngles{0.1, 0, 0, -0.1, -0.5, 3.2};  // 6 deg, -6 deg, 183 deg
  program.steps = {move};
  EXPECT_TRUE(has(text_of(program), "],[0,-1,2,1],[9E9,"));
}

TEST(RapidWriter, SettingsThatMakeNoSenseAreRefused) {
  Program program = empty_rapid_program();
  program.steps = {rapid_move(0, 0, 0)};
  WriteSettings settings;
  settings.max_lines = 3;
  EXPECT_THROW(written(program, settings), InvalidParameter);
  settings = {};
  settings.dialect = "krc4";
  EXPECT_THROW(written(program, settings), InvalidParameter);
  program.steps.clear();
  EXPECT_THROW(written(program), UnusableInput);
}

TEST(RapidWriter, ALocaleWithDecimalCommasChangesNothing) {
  Program program = empty_rapid_program();
  program.steps = {rapid_move(0.0015, 0, 0, 0.0123, 0.0025), JointMove{{1.5, 2, 3, 4, 5, 6.25}}};
  const std::string text = text_of(program);
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) GTEST_SKIP() << "no such locale here";
  const std::string again = text_of(program);
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(again, text);
}

}  // namespace
}  // namespace tool_path_programs
