// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_demo/comparison.h"

using tool_path_stretcher::ToolPath;

namespace {

ToolPath three_waypoints() {
  ToolPath path;
  path.segments.resize(1);
  for (const double x : {0.0, 0.1, 0.2}) {
    path.segments[0].waypoints.push_back({Eigen::Isometry3d(Eigen::Translation3d(x, 0, 0)), {}});
  }
  return path;
}

}  // namespace

TEST(ComparePaths, GivesRootMeanSquareAndLargestDistanceAndAngle) {
  ToolPath moved = three_waypoints();
  moved.segments[0].waypoints[0].pose.translation().z() += 3e-3;
  moved.segments[0].waypoints[2].pose.translation().y() -= 4e-3;
  moved.segments[0].waypoints[1].pose.rotate(
      Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 1, 0).normalized()));
  const auto error = scan_cell_demo::compare(moved, three_waypoints());
  EXPECT_NEAR(error.rms, std::sqrt((9e-6 + 16e-6) / 3), 1e-12);
  EXPECT_NEAR(error.max, 4e-3, 1e-12);
  EXPECT_NEAR(error.orientation_rms, 0.3 / std::sqrt(3.0), 1e-9);
}

TEST(CompareLines, TakesAPathThatRunsTheOtherWayForTheSame) {
  ToolPath backwards = three_waypoints();
  auto& waypoints = backwards.segments[0].waypoints;
  std::reverse(waypoints.begin(), waypoints.end());
  for (auto& waypoint : waypoints)
    waypoint.pose.rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ()));
  const auto same = scan_cell_demo::compare_lines(backwards, three_waypoints());
  EXPECT_NEAR(same.max, 0, 1e-12);
  EXPECT_NEAR(same.orientation_rms, 0, 1e-9);
  waypoints[0].pose.translation().z() += 3e-3;
  EXPECT_NEAR(scan_cell_demo::compare_lines(backwards, three_waypoints()).max, 3e-3, 1e-12);
}

TEST(CompareLines, FindsWhatOnlyTheTruthCovers) {
  ToolPath shorter = three_waypoints();
  const double lost = (shorter.segments[0].waypoints[2].pose.translation() -
                       shorter.segments[0].waypoints[1].pose.translation())
                          .norm();
  shorter.segments[0].waypoints.pop_back();
  EXPECT_NEAR(scan_cell_demo::compare_lines(shorter, three_waypoints()).max, lost, 1e-12);
}

TEST(CompareWay, MeasuresFromEachTrueWaypointToTheWayOfTheTip) {
  // 0.3 mm beside the path, and 4 mm too short; not sampled at the waypoints
  const std::vector<Eigen::Vector3d> way = {{-0.01, 3e-4, 0}, {0.07, 3e-4, 0}, {0.196, 3e-4, 0}};
  const auto error = scan_cell_demo::compare_way(way, three_waypoints());
  const double last = std::hypot(4e-3, 3e-4);
  EXPECT_NEAR(error.max, last, 1e-12);
  EXPECT_NEAR(error.rms, std::sqrt((2 * 9e-8 + last * last) / 3), 1e-12);
}

TEST(CompareWay, RefusesAWayThatNobodyRecorded) {
  EXPECT_THROW(scan_cell_demo::compare_way({}, three_waypoints()), scan_cell_common::UnusableInput);
  EXPECT_THROW(scan_cell_demo::compare_way({{0, 0, 0}}, ToolPath()),
               scan_cell_common::UnusableInput);
}

TEST(ComparePaths, RefusesPathsOfDifferentLength) {
  ToolPath longer = three_waypoints();
  longer.segments[0].waypoints.emplace_back();
  EXPECT_THROW(scan_cell_demo::compare(longer, three_waypoints()), scan_cell_common::UnusableInput);
}
