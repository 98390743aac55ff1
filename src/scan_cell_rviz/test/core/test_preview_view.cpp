// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/made_preview.h"
#include "preview/preview_view.h"

namespace scan_cell_rviz {
namespace {

TEST(PreviewView, TellsWaypointSpeedOutputsAndJoints) {
  EXPECT_EQ(text_at(made_preview(), 2).toStdString(),
            "waypoint 1: 30 mm/s, output 1, 3 on\nJ1 11.5, J2 -22.9 degrees");
  EXPECT_EQ(text_at(made_preview(), 0).toStdString(),
            "on the way to or from the path: 10 mm/s, all outputs off\nJ1 0.0, J2 0.0 degrees");
}

TEST(PreviewView, HasNoJointsWhereTheRobotDoesNotGetOrThereIsNoPose) {
  EXPECT_EQ(joints_at(made_preview(), 3).at("J2"), -0.2 * 3);
  EXPECT_TRUE(joints_at(made_preview(), 4).empty());
  EXPECT_TRUE(joints_at(made_preview(), 5).empty());
  EXPECT_NE(text_at(made_preview(), 4).indexOf("does not get there"), -1);
  EXPECT_TRUE(text_at(made_preview(), 5).isEmpty());
  EXPECT_TRUE(text_at({}, 0).isEmpty());
}

TEST(PreviewView, TakesTheSpeedsOfThePathAloneForItsColours) {
  const SpeedRange range = speeds_of(made_preview());
  EXPECT_DOUBLE_EQ(range.least, 0.03);  // the way to waypoint 0 is the approach's
  EXPECT_DOUBLE_EQ(range.most, 0.04);
  const SpeedRange none = speeds_of({});
  EXPECT_EQ(none.least, 0);
  EXPECT_EQ(none.most, 0);
}

TEST(PreviewView, ColoursGrowLighterWithTheSpeed) {
  const auto luminance = [](double speed) {  // Rec. 709
    const auto rgb = colour_of(speed, {1, 2});
    return 0.2126F * rgb[0] + 0.7152F * rgb[1] + 0.0722F * rgb[2];
  };
  for (int i = 0; i < 20; ++i)
    EXPECT_LT(luminance(1 + 0.05 * i), luminance(1 + 0.05 * (i + 1))) << i;
  EXPECT_EQ(colour_of(0, {1, 2}), colour_of(1, {1, 2}));
  EXPECT_EQ(colour_of(3, {1, 2}), colour_of(2, {1, 2}));
}

}  // namespace
}  // namespace scan_cell_rviz
