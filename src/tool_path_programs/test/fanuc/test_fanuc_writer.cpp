// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <clocale>
#include <random>

#include "fanuc_examples.h"
#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;

WrittenProgram written(const Program& program, const WriteSettings& settings = {}) {
  return write_checked(fanuc(), program, settings);
}

std::string text_of(const Program& program, const WriteSettings& settings = {}) {
  return written(program, settings).files.front().text;
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

Program with(const Step& step) {
  Program program = empty_fanuc_program();
  program.steps = {fanuc_move(0, 0, 0, 0.05, 0), step};
  return program;
}

WriteSettings corner_regions() {
  WriteSettings settings;
  settings.dialect = "cr";
  return settings;
}

TEST(FanucWriter, SaysFramesSpeedsZonesAndOutputs) {
  Program program = empty_fanuc_program();
  program.comments = {"part 17; a comment that is longer than 32 characters"};
  Move approach = fanuc_move(0, 0, 0.1, 0.25, 0);
  approach.kind = MotionKind::kJoint;
  Move arc = fanuc_move(0.3, 0, 0, 0.05, 0.003);
  arc.kind = MotionKind::kCircular;
  arc.via = fanuc_move(0.25, 0.05, 0).pose;
  program.steps = {approach,
                   fanuc_move(0, 0, 0, 0.05, 0),
                   SetOutput{"5", true},
                   fanuc_move(0.1, 0, 0, 0.01 / 60 * 7, 0.002),
                   arc,
                   fanuc_move(0.4, 0, 0, 0.05, 0),
                   SetOutput{"RO[2]", false}};
  const std::string text = text_of(program, corner_regions());
  EXPECT_TRUE(has(text,
                  "   1:  !part 17? a comment that is longe;\r\n"
                  "   2:  !r than 32 characters;\r\n"
                  "   3:  UFRAME_NUM=2 ;\r\n   4:  UTOOL_NUM=1 ;\r\n"
                  "   5:J P[1] 10% FINE    ;\r\n   6:L P[2] 50mm/sec FINE    ;\r\n"
                  "   7:  DO[5]=ON ;\r\n   8:L P[3] 7cm/min CR2    ;\r\n"
                  "   9:C P[4] \r\n    :  P[5] 50mm/sec CR3    ;\r\n"
                  "  10:L P[6] 50mm/sec FINE    ;\r\n  11:  RO[2]=OFF ;\r\n/POS\r\n"));
  EXPECT_TRUE(has(text, "LINE_COUNT\t= 11;"));
  EXPECT_TRUE(has(text,
                  "P[3]{\r\n   GP1:\r\n\tUF : 2, UT : 1,\t\tCONFIG : 'N U T, 0, 0, 0',\r\n"
                  "\tX =   100.000  mm,\tY =     0.000  mm,"));
  EXPECT_TRUE(has(text_of(program), "L P[3] 7cm/min CNT100    ;"));
}

TEST(FanucWriter, SpeedsAreSaidInTheUnitThatSaysThemBest) {
  EXPECT_TRUE(has(text_of(with(fanuc_move(0, 0, 0, 0.012))), " 12mm/sec "));
  EXPECT_TRUE(has(text_of(with(fanuc_move(0, 0, 0, 0.0127 / 60 * 3))), " 1.5inch/min "));
  EXPECT_TRUE(has(text_of(with(fanuc_move(0, 0, 0, 0.0254 / 60))), " 1.0inch/min "));
}

TEST(FanucWriter, HundredThousandWaypointsComeBack) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  Program program = empty_fanuc_program();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  for (int i = 0; i < 100000; ++i) {
    Move move = fanuc_move(2 * number(random), 2 * number(random), 2 * number(random),
                           1e-3 * (1 + i % 500), i % 3 == 0 ? 0 : 0.002);
    turn =
        turn * Eigen::AngleAxisd(number(random),
                                 Eigen::Vector3d(number(random), number(random), 1.1).normalized());
    move.pose.linear() = turn.normalized().toRotationMatrix();
    program.steps.emplace_back(move);
    if (i % 3000 == 0) program.steps.emplace_back(SetOutput{"12", i % 2000 == 0});
  }
  const WrittenProgram result = written(program, corner_regions());
  EXPECT_EQ(result.files.size(), 12u);
  EXPECT_EQ(result.files[11].name, "PART_11.ls");
  EXPECT_TRUE(has(result.files[0].text, ":  CALL PART_11 ;"));
}

TEST(FanucWriter, WhatItCannotSayIsRefusedWithTheWaypointAndACure) {
  EXPECT_EQ(fault_of(with(fanuc_move(0, 0, 0, 4e-4))),
            "FANUC TP, waypoint 2: speed 0.4 mm/s, which would become 0.9inch/min; whole mm/sec, "
            "whole cm/min and tenths of inch/min are possible: give one of these, or a greater "
            "max_speed_change");
  EXPECT_TRUE(has(fault_of(with(fanuc_move(0, 0, 0, 1e-6))),
                  "waypoint 2: speed 0.001 mm/s, which "
                  "would become 0;"));
  EXPECT_TRUE(has(fault_of(with(fanuc_move(0, 0, 0, 2.1))), "give at most 2000 mm/s"));
  EXPECT_TRUE(has(fault_of(with(fanuc_move(0, 0, 0, 0.05, 0.0015)), corner_regions()),
                  "waypoint 2: zone 1.5 mm"));
  Move turned = fanuc_move(0, 0, 0);
  turned.pose.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  EXPECT_TRUE(has(fault_of(with(turned)), "waypoint 2: turned by 180 degrees"));
  Move joint = fanuc_move(0, 0, 0);
  joint.kind = MotionKind::kJoint;
  joint.joint_speed = 0.004;
  EXPECT_TRUE(has(fault_of(with(joint)), "waypoint 2: 0.4 % of the axes' speed"));
  EXPECT_TRUE(has(fault_of(with(SetOutput{"doGun", true})), "output 'doGun'"));
  EXPECT_TRUE(has(fault_of(with(SetOutput{"0", true})), "output '0'"));
  Program early = with(fanuc_move(0, 0, 0));
  early.steps.emplace_back(SetOutput{"5", true});
  EXPECT_TRUE(has(fault_of(early), "let the tool stop there"));
  EXPECT_TRUE(has(fault_of(with(fanuc_move(NAN, 0, 0))), "waypoint 2: its pose is not finite"));
}

TEST(FanucWriter, NamesAndFramesThatWouldNotDoAreRefused) {
  Program program = with(fanuc_move(0.1, 0, 0));
  program.name = "part 17";
  EXPECT_TRUE(has(fault_of(program), "name it part_17, for example"));
  program.name = "17";
  EXPECT_TRUE(has(fault_of(program), "name it P17, for example"));
  program.name = std::string(200, 'X');
  EXPECT_TRUE(has(fault_of(program), "at most 31 ASCII letters"));
  program.name = "PART";
  program.frames[0].tool.name = "";
  EXPECT_TRUE(has(fault_of(program), "FANUC TP, tool: no number"));
  program.frames[0].tool.name = "gun";
  EXPECT_TRUE(has(fault_of(program), "FANUC TP, tool: 'gun'"));
  program.frames[0].tool = {"0", Eigen::Isometry3d(Eigen::Translation3d(0, 0, 1))};
  EXPECT_TRUE(has(fault_of(program), "0, which is fixed"));
}

TEST(FanucWriter, WhereAFrameMustBeStandsInTheProgramAndTheNotes) {
  Program program = with(fanuc_move(0.1, 0, 0));
  program.frames[0].user.pose = Eigen::Isometry3d(Eigen::Translation3d(1.2, -0.4, 0.5));
  const WrittenProgram result = written(program);
  EXPECT_TRUE(has(result.files[0].text, "!UFRAME 2: X 1200.000 Y -400.000;"));
  EXPECT_TRUE(has(result.notes.back(), "UFRAME 2 must be set on the controller to X 1200.000"));
}

TEST(FanucWriter, LongProgramsAreSplitAndReadInTheirOrder) {
  Program program = empty_fanuc_program();
  for (int i = 0; i < 70; ++i)
    program.steps.emplace_back(fanuc_move(0.01 * i, 0, 0));
  WriteSettings settings;
  settings.max_lines = 30;
  const WrittenProgram result = written(program, settings);
  ASSERT_EQ(result.files.size(), 4u);
  EXPECT_TRUE(has(result.files[0].text, "   1:  CALL PART_1 ;\r\n   2:  CALL PART_2 ;\r\n"));
  EXPECT_TRUE(has(result.files[2].text, "   1:  UFRAME_NUM=2 ;\r\n   2:  UTOOL_NUM=1 ;\r\n"));
}

TEST(FanucWriter, SettingsThatMakeNoSenseAreRefused) {
  Program program = with(fanuc_move(0.1, 0, 0));
  WriteSettings settings;
  settings.max_lines = 3;
  EXPECT_THROW(written(program, settings), InvalidParameter);
  settings = {};
  settings.dialect = "krc4";
  EXPECT_THROW(written(program, settings), InvalidParameter);
  program.steps.clear();
  EXPECT_THROW(written(program), UnusableInput);
}

TEST(FanucWriter, TurnsOfTheAxesAreThoseOfTheJoints) {
  Move move = fanuc_move(0.1, 0, 0);
  move.joints = JointAngles{0.1, 0, 0, 3.2, -0.5, -3.2};  // 183 and -183 degrees
  EXPECT_TRUE(has(text_of(with(move)), "CONFIG : 'N U T, 0, 1, -1'"));
  EXPECT_TRUE(has(text_of(with(JointMove{{1.5, 2, 3, 4, 5, 6.25}})), "J6=     6.250 deg"));
  EXPECT_NE(fault_of(with(JointMove{{1.00001, 2, 3, 4, 5, 6.25}})), "");
}

TEST(FanucWriter, ALocaleWithDecimalCommasChangesNothing) {
  const Program program = with(fanuc_move(0.0015, 0, 0));
  const std::string text = text_of(program);
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) GTEST_SKIP() << "no such locale here";
  const std::string again = text_of(program);
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(again, text);
}

}  // namespace
}  // namespace tool_path_programs
