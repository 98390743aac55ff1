// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

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

TEST(ComparePaths, RefusesPathsOfDifferentLength) {
  ToolPath longer = three_waypoints();
  longer.segments[0].waypoints.emplace_back();
  EXPECT_THROW(scan_cell_demo::compare(longer, three_waypoints()), scan_cell_common::UnusableInput);
}
