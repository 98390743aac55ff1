// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tool_path_programs/read_back.h"

namespace tool_path_programs {
namespace {

Program example() {
  Program program;
  program.name = "part";
  program.frames = {{}};
  Move move;
  move.zone = 0.001;
  program.steps = {move, SetOutput{"5", true}, move, SetOutput{"5", false}};
  return program;
}

std::string difference_after(const std::function<void(Program&)>& change) {
  Program read = example();
  change(read);
  return first_difference(example(), read, {});
}

Move& move_of(Program& program) {
  return std::get<Move>(program.steps[2]);
}

TEST(ReadBack, TheSameProgramHasNoDifference) {
  EXPECT_EQ(first_difference(example(), example(), {}), "");
}

TEST(ReadBack, EachDifferenceIsNamedWithItsWaypoint) {
  EXPECT_EQ(difference_after([](Program& p) { move_of(p).pose.translation().x() += 2e-6; }),
            "step 3, waypoint 2: position 0.002 mm off");
  EXPECT_EQ(
      difference_after([](Program& p) {
        move_of(p).pose.rotate(Eigen::AngleAxisd(0.0011 * M_PI / 180, Eigen::Vector3d::UnitX()));
      }),
      "step 3, waypoint 2: turned by 0.0011 degrees");
  EXPECT_EQ(difference_after([](Program& p) { move_of(p).speed = 0.0511; }),
            "step 3, waypoint 2: 51.1 mm/s instead of 50 mm/s");
  EXPECT_EQ(difference_after([](Program& p) { move_of(p).zone = 0; }),
            "step 3, waypoint 2: zone 0 mm instead of 1 mm");
  EXPECT_EQ(difference_after([](Program& p) { std::get<SetOutput>(p.steps[1]).on = false; }),
            "step 2, waypoint 1: output 5 off instead of 5 on");
  EXPECT_EQ(difference_after([](Program& p) { p.steps.pop_back(); }), "3 steps instead of 4");
  EXPECT_EQ(difference_after([](Program& p) { std::swap(p.steps[1], p.steps[2]); }),
            "step 2, waypoint 1: another kind of step");
}

TEST(ReadBack, WhatALanguageLeavesOpenIsNotCompared) {
  Program read = example();
  move_of(read).zone = 0;
  move_of(read).pose.rotate(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()));
  EXPECT_NE(first_difference(example(), read, {true, false}), "");
  EXPECT_EQ(first_difference(example(), read, {true, true}), "");
}

}  // namespace
}  // namespace tool_path_programs
