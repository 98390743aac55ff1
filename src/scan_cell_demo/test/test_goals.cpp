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
  figures.cloud_rms = 0.29e-3;
  figures.path_rms = 0.99e-3;
  figures.pulses = 1000;
  figures.frames_bound = 990;
  figures.frames_accounted_for = 10;
  return figures;
}

std::string only_miss(const Figures& figures) {
  const auto missed = missed_goals(figures);
  return missed.size() == 1 ? missed.front() : std::to_string(missed.size()) + " missed";
}

}  // namespace

TEST(Goals, AreMetByGoodFigures) {
  EXPECT_TRUE(missed_goals(good()).empty());
}

TEST(Goals, NameWhatWasMissed) {
  Figures figures = good();
  figures.cloud_rms = 0.31e-3;
  EXPECT_EQ(only_miss(figures), "a cloud is 0.31 mm RMS off the ground truth; the goal is 0.3 mm");
  figures = good();
  figures.path_rms = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(only_miss(figures), "the path is nan mm RMS off the ground truth; the goal is 1 mm");
  figures = good();
  figures.frames_accounted_for = 7;
  EXPECT_EQ(only_miss(figures), "3 of 1000 pulses are not accounted for");
  figures = good();
  figures.frames_bound = 500;
  figures.frames_accounted_for = 500;
  EXPECT_EQ(only_miss(figures), "only 500 of 1000 pulses gave a frame with a pose");
}
