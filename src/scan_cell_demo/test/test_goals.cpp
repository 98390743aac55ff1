// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "core/goals.h"

using scan_cell_demo::Figures;
using scan_cell_demo::missed_goals;

namespace {

Figures good() {
  Figures figures;
  figures.cloud_rms = 0.09e-3;
  figures.path_rms = 0.19e-3;
  figures.path_max = 0.49e-3;
  figures.pulses = 1000;
  figures.frames_bound = 990;
  figures.frames_accounted_for = 10;
  return figures;
}

std::string only_miss(const Figures& figures) {
  const auto missed = missed_goals(figures, {});
  return missed.size() == 1 ? missed.front() : std::to_string(missed.size()) + " missed";
}

}  // namespace

TEST(Goals, AreMetByGoodFigures) {
  EXPECT_TRUE(missed_goals(good(), {}).empty());
}

TEST(Goals, NameWhatWasMissed) {
  Figures figures = good();
  figures.cloud_rms = 0.11e-3;
  EXPECT_EQ(only_miss(figures), "a cloud is 0.11 mm RMS off the ground truth; the goal is 0.1 mm");
  figures = good();
  figures.path_rms = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(only_miss(figures), "the path is nan mm RMS off the ground truth; the goal is 0.2 mm");
  figures = good();
  figures.path_max = 0.51e-3;
  EXPECT_EQ(only_miss(figures),
            "the farthest waypoint is 0.51 mm off the ground truth; the goal is 0.5 mm");
  figures = good();
  figures.frames_accounted_for = 7;
  EXPECT_EQ(only_miss(figures), "3 of 1000 pulses are not accounted for");
  figures = good();
  figures.frames_bound = 500;
  figures.frames_accounted_for = 500;
  EXPECT_EQ(only_miss(figures), "only 500 of 1000 pulses gave a frame with a pose");
}

TEST(Goals, CountTheTipWhereTheRobotWorked) {
  Figures figures = good();
  figures.tip_rms = 0.4e-3;
  EXPECT_TRUE(missed_goals(figures, {}).empty()) << "it did not work";
  figures.worked = true;
  EXPECT_EQ(only_miss(figures),
            "the tool's tip went 0.4 mm RMS off the ground truth; the goal is 0.3 mm");
  figures.tip_rms = 0.1e-3;
  figures.tip_max = 0.9e-3;
  EXPECT_EQ(
      only_miss(figures),
      "at the farthest waypoint the tip went 0.9 mm off the ground truth; the goal is 0.8 mm");
}

TEST(Goals, MayBeWider) {
  Figures figures = good();
  figures.path_rms = 0.5e-3;
  scan_cell_demo::Goals goals;
  goals.path_rms = 0.6e-3;
  EXPECT_TRUE(missed_goals(figures, goals).empty());
}
