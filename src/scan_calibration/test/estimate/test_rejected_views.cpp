// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdio>

#include "estimate/example_sessions.h"
#include "scan_calibration/calibration.h"
#include "sequential.h"

using Eigen::Vector2d;
using Eigen::Vector3d;
using scan_calibration::calibrate;
using scan_calibration::Calibration;
using scan_calibration::Observations;
using scan_calibration::RejectedView;
using synthetic::expect_true;
using synthetic::some_views;
using synthetic::spoil_corners;

namespace {

std::string reason_of(const Calibration& calibration, const std::string& view,
                      const std::string& laser) {
  for (const RejectedView& one : calibration.rejected)
    if (one.name == view && one.laser == laser) return one.reason;
  return "not rejected";
}

}  // namespace

TEST(Calibration, LeavesOutAViewWhosePoseIsWrongAndSaysByHowMuch) {
  const synthetic::Cell cell;
  Observations observations = some_views(25);
  observations.views[7].base_to_flange.pretranslate(Vector3d(0.002, 0, 0));
  observations.views[11].base_to_flange.rotate(Eigen::AngleAxisd(0.2, Vector3d::UnitX()));
  const Calibration found = calibrate(observations, {});
  double said_mm = 0;
  EXPECT_EQ(std::sscanf(reason_of(found, "view7", "").c_str(), "its pose is %lf mm", &said_mm), 1)
      << reason_of(found, "view7", "");
  EXPECT_NEAR(said_mm, 2, 0.3);
  EXPECT_NE(reason_of(found, "view11", "").find("from where the other views have it"),
            std::string::npos)
      << reason_of(found, "view11", "");
  EXPECT_EQ(found.rejected.size(), 2u);
  EXPECT_EQ(found.views.size(), 23u);
  expect_true(cell, found);
}

TEST(Calibration, LeavesOutAViewWhoseCornersAreWrong) {
  const synthetic::Cell cell;
  Observations observations = some_views(25);
  spoil_corners(observations.views[3]);
  const Calibration found = calibrate(observations, {});
  EXPECT_NE(reason_of(found, "view3", "").find("its corners miss"), std::string::npos);
  EXPECT_EQ(found.rejected.size(), 1u);
  expect_true(cell, found);
}

TEST(Calibration, LeavesOutSingleCornersAndSaysSo) {
  const synthetic::Cell cell;
  Observations observations = some_views(25);
  observations.views[3].corners[10].pixel.x() += 3;
  const Calibration found = calibrate(observations, {});
  ASSERT_EQ(found.views.size(), 25u);
  EXPECT_EQ(found.views[3].left_out_corners, std::vector<std::size_t>{10});
  EXPECT_NE(found.notes.back().find("1 corners and 0 laser points are outliers"),
            std::string::npos);
  EXPECT_EQ(used_views(observations, found).views[3].corners.size(), 374u);
  expect_true(cell, found);
}

TEST(Calibration, LeavesOutALineThatIsAReflection) {
  const synthetic::Cell cell;
  Observations observations = some_views(25);
  for (Vector2d& point : observations.views[5].lines[1])
    point.x() += 25;
  const Calibration found = calibrate(observations, {});
  EXPECT_NE(reason_of(found, "view5", "laser_1").find("miss the laser's plane"), std::string::npos);
  EXPECT_EQ(found.rejected.size(), 1u);
  EXPECT_TRUE(used_views(observations, found).views[5].lines[1].empty());
  expect_true(cell, found);
}

TEST(Calibration, LeavesNothingOutOfGoodSessions) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Calibration found = calibrate(some_views(15, seed), {});
    EXPECT_TRUE(found.rejected.empty()) << found.rejected.front().reason;
  }
}

TEST(Calibration, NamesAViewThatRepeatsAnother) {
  Observations observations = some_views(15);
  scan_calibration::ViewObservation again = observations.views[4];
  again.name = "again";
  observations.views.push_back(again);
  const Calibration found = calibrate(observations, {});
  EXPECT_EQ(reason_of(found, "again", ""), "repeats the pose of view4: it shows nothing new");
  EXPECT_EQ(found.views.size(), 15u);
}
