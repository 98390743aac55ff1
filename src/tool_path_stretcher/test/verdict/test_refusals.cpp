// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "report.h"
#include "scan_cell_common/errors/errors.h"
#include "stretch_case.h"
#include "tool_paths/tool_path_files.h"

using namespace tool_path_stretcher;

TEST(Refusal, OfAWrongPart) {
  Case panel;
  panel.scanned_part = synthetic::curved_panel();
  expect_refused(panel.run(), Reason::kWrongPart);
  Case box;
  box.scanned_part = synthetic::box_lid();
  expect_refused(box.run(), Reason::kWrongPart);
}

TEST(Refusal, OfASymmetricPart) {
  Case each;
  each.part = each.scanned_part = synthetic::photo_frame(0);
  expect_refused(each.run(), Reason::kAmbiguous);
}

TEST(Refusal, OfAScaleOutOfBounds) {
  Case each;
  each.moved.scale = 2.6;
  expect_refused(each.run(), Reason::kScaleAtBound);
}

TEST(Refusal, OfCloudsInDifferentUnits) {
  Case each;
  each.moved.scale = 1000;
  each.scan.noise = 0.1;
  const StretchResult result = each.run();
  expect_refused(result, Reason::kUnusableInput);
  EXPECT_NE(result.verdict.message.find("millimetres"), std::string::npos);
}

TEST(Refusal, OfAPathOffTheReferenceNamesTheWaypoints) {
  Case each;
  std::vector<std::size_t> off;
  for (std::size_t i = 0; i < kWaypoints; ++i) {
    if (i % 3 == 0) continue;
    const std::size_t half = kWaypoints / 2;
    each.path.segments[i / half].waypoints[i % half].pose.translation().z() += 0.5;
    off.push_back(i);
  }
  const StretchResult result = each.run();
  expect_refused(result, Reason::kPathOffReference);
  EXPECT_EQ(result.verdict.waypoints, off);
}

TEST(Refusal, OfAPathBesideTheReferenceDoesNotTakeItForMillimetres) {
  Case each;
  for (Segment& segment : each.path.segments) {
    for (Waypoint& waypoint : segment.waypoints)
      waypoint.pose.translation().y() += 0.4;
  }
  expect_refused(each.run(), Reason::kPathOffReference);
}

TEST(Refusal, OfAPathThatWasNotScannedNamesTheWaypoints) {
  Case each;
  const auto is_hole = [](const Eigen::Vector3d& at) { return at.x() > 0.02 && at.y() < -0.03; };
  each.scan.is_hole = is_hole;
  const StretchResult result = each.run();
  expect_refused(result, Reason::kPathNotScanned);
  std::size_t index = 0;
  std::vector<std::size_t> inside;
  for (const Segment& segment : each.path.segments) {
    for (const Waypoint& waypoint : segment.waypoints) {
      if (is_hole(waypoint.pose.translation())) inside.push_back(index);
      ++index;
    }
  }
  ASSERT_FALSE(result.verdict.waypoints.empty());
  for (const std::size_t waypoint : result.verdict.waypoints)
    EXPECT_EQ(std::count(inside.begin(), inside.end(), waypoint), 1) << waypoint;
}

TEST(Refusal, OfTooFewPoints) {
  Case each;
  each.scan.points = 100;
  expect_refused(each.run(), Reason::kTooFewPoints);
}

TEST(Refusal, OfUnusablePaths) {
  Case each;
  each.path.segments.clear();
  expect_refused(each.run(), Reason::kUnusableInput);
  Case nan;
  nan.path.segments[0].waypoints[0].pose.translation().x() = std::nan("");
  expect_refused(nan.run(), Reason::kUnusableInput);
}

TEST(Refusal, OfAToleranceThatIsExceeded) {
  Case each;
  each.deformation = synthetic::bend(0.004, 0.200);
  each.parameters.max_displacement_ratio = 0.0015;
  const StretchResult result = each.run();
  expect_refused(result, Reason::kToleranceExceeded);
  EXPECT_FALSE(result.verdict.waypoints.empty());
}

TEST(Refusal, OfSomethingThatLiesAcrossThePath) {
  Case each;
  constexpr double kHigh = 0.009;  // [m]
  const Eigen::Vector3d middle = each.path.segments[0].waypoints[kWaypoints / 8].pose.translation();
  each.scanned_part.height = [height = each.part.height, middle](double x, double y) {
    constexpr double kHalfWide = 0.004;
    const bool covered = std::abs(x - middle.x()) < kHalfWide && std::abs(y - middle.y()) < 0.02;
    return height(x, y) + (covered ? kHigh : 0);
  };
  const StretchResult result = each.run();
  expect_refused(result, Reason::kWrongPart);
  EXPECT_NE(
      std::find(result.verdict.waypoints.begin(), result.verdict.waypoints.end(), kWaypoints / 8),
      result.verdict.waypoints.end());
  EXPECT_LT(result.verdict.waypoints.size(), kWaypoints / 4);
}

TEST(Refusal, OfAPartThatWouldHaveToBeBentTooFar) {
  Case each;
  each.deformation = synthetic::bend(0.008, 0.200);
  each.parameters.max_deformation_ratio = 0.003;
  expect_refused(each.run(), Reason::kWrongPart);
}
