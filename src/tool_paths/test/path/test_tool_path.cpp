// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/errors/errors.h"
#include "tool_paths/tool_path.h"

using namespace tool_paths;

namespace {

Waypoint waypoint(double x, double angle, double speed) {
  Waypoint result;
  result.pose.translation().x() = x;
  result.pose.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  result.process_values = {speed};
  return result;
}

ToolPath line() {
  ToolPath path;
  path.has_orientation = true;
  path.process_names = {"speed"};
  path.segments = {{"on", {waypoint(0, 0, 1), waypoint(0.03, 0.6, 4), waypoint(0.1, 0.6, 4)}},
                   {"dwell", {waypoint(0.2, 0, 2), waypoint(0.2, 1, 3)}},
                   {"one", {waypoint(0.3, 0, 5)}}};
  return path;
}

}  // namespace

TEST(Resampling, StepsEvenlyAlongEachSegmentAndKeepsItsEnds) {
  const ToolPath path = resampled(line(), 0.01);
  ASSERT_EQ(path.segments.size(), 3U);
  const std::vector<Waypoint>& on = path.segments[0].waypoints;
  ASSERT_EQ(on.size(), 11U);
  for (std::size_t i = 0; i < on.size(); ++i) {
    const double x = 0.01 * static_cast<double>(i);
    EXPECT_NEAR(on[i].pose.translation().x(), x, 1e-12);
    const double angle = std::min(0.6, 20 * x);
    EXPECT_NEAR(Eigen::AngleAxisd(on[i].pose.linear()).angle(), angle, 1e-9);
    EXPECT_NEAR(on[i].process_values[0], std::min(4.0, 1 + 100 * x), 1e-9);
  }
  EXPECT_EQ(path.segments[1].waypoints.size(), 2U);
  EXPECT_EQ(path.segments[2].waypoints.size(), 1U);
}

TEST(Resampling, NeverStepsFartherThanAsked) {
  const ToolPath path = resampled(line(), 0.03);
  EXPECT_EQ(path.segments[0].waypoints.size(), 5U);  // four steps of 25 mm
  EXPECT_EQ(path.segments[0].waypoints.back().pose.translation().x(), 0.1);
  EXPECT_EQ(resampled(line(), 5).segments[0].waypoints.size(), 2U);
}

TEST(Resampling, RefusesMoreWaypointsThanAnyoneNeeds) {
  EXPECT_THROW(resampled(line(), 1e-9), scan_cell_common::UnusableInput);
}
