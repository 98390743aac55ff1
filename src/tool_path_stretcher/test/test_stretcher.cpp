// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "report.h"
#include "scan_cell_common/errors/errors.h"
#include "stretch_case.h"
#include "tool_paths/tool_path_files.h"

using namespace tool_path_stretcher;

TEST(Stretcher, StandsAnyRotationAboutTheVertical) {
  for (const double degrees : {0.0, 95.0, 178.0, 260.0, 359.0}) {
    SCOPED_TRACE(degrees);
    Case each;
    each.moved.rotation = about_vertical(degrees);
    expect_adapted(each, 0.0001, 0.5 * kDegree);
  }
}

TEST(Stretcher, StandsAnyRotationAndScale) {
  const std::vector<double> scales = {0.5, 0.8, 1.25, 2.0};
  for (unsigned i = 0; i < scales.size(); ++i) {
    SCOPED_TRACE(scales[i]);
    Case frame;
    frame.moved = synthetic::similarity(scales[i], synthetic::random_rotation(i + 1), {5, -3, 2});
    expect_adapted(frame, 0.0001, 1.0 * kDegree);
    Case panel;
    panel.part = panel.scanned_part = synthetic::curved_panel();
    panel.path = synthetic::path_on(panel.part, kWaypoints);
    panel.moved = synthetic::similarity(scales[i], synthetic::random_rotation(i + 31), {5, -3, 2});
    expect_adapted(panel, 0.0003, 1.0 * kDegree);
  }
}

TEST(Stretcher, FindsThePoseFromTheOneSmallFeatureOfABentHalfSeenFrame) {
  for (const double degrees : {20.0, 200.0}) {
    SCOPED_TRACE(degrees);
    Case each;
    each.moved.rotation = about_vertical(degrees);
    each.deformation = synthetic::bend(0.004, 0.200);
    each.scan.view = {0.6, 0, 1};
    each.scan.min_facing = 0.6;
    expect_adapted(each, 0.0003, 1.0 * kDegree);
  }
}

TEST(Stretcher, IsNotMisledByUnevenDensity) {
  Case each;
  each.scan.uneven = true;
  expect_adapted(each, 0.0001, 0.5 * kDegree);
}

TEST(Stretcher, FollowsABentPanel) {
  Case each;
  each.part = each.scanned_part = synthetic::curved_panel();
  each.path = synthetic::path_on(each.part, kWaypoints);
  each.deformation = synthetic::bend(0.004, 0.300);
  expect_adapted(each, 0.0006, 1.0 * kDegree);
}

TEST(Stretcher, FollowsNoDeformationWhereThereIsNone) {
  const Case each;
  const StretchResult result = each.run();
  EXPECT_EQ(result.deformation_nodes, 0U);
  for (const WaypointQuality& quality : result.quality)
    EXPECT_LT(quality.displacement, 0.00015);
}

TEST(Stretcher, SetsThePathIntoALocalDent) {
  Case each;
  // A dent of 1 mm, too narrow for a deformation of the whole part to follow.
  each.deformation = [](const Eigen::Vector3d& at) {
    const double away = std::hypot(at.x() + 0.0875, at.y() - 0.01) / 0.015;
    return Eigen::Vector3d(0, 0, -0.001 * std::exp(-away * away));
  };
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_LE(each.error(result).max, 0.0003);
  EXPECT_LE(each.error(result).rms, 0.0001);
}

TEST(Stretcher, IsNotMisledByLooseOutliers) {
  for (const unsigned seed :
       {7U, 8U}) {  // without care, these are refused or taken for the 180 degree twin
    SCOPED_TRACE(seed);
    Case each;
    each.moved.rotation = synthetic::random_rotation(300 + seed);
    each.scan.seed = seed;
    each.scan.outliers = 1000;
    expect_adapted(each, 0.0001, 0.5 * kDegree);
  }
}

TEST(Stretcher, KeepsOrderCountNamesAndProcessValues) {
  const Case each;
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_EQ(result.path.name, each.path.name);
  EXPECT_EQ(result.path.process_names, each.path.process_names);
  ASSERT_EQ(result.path.segments.size(), each.path.segments.size());
  ASSERT_EQ(result.quality.size(), kWaypoints);
  for (std::size_t s = 0; s < each.path.segments.size(); ++s) {
    const Segment& before = each.path.segments[s];
    const Segment& after = result.path.segments[s];
    EXPECT_EQ(before.name, after.name);
    ASSERT_EQ(before.waypoints.size(), after.waypoints.size());
    for (std::size_t w = 0; w < before.waypoints.size(); ++w) {
      EXPECT_EQ(before.waypoints[w].process_values, after.waypoints[w].process_values);
      const Eigen::Matrix3d rotation = after.waypoints[w].pose.linear();
      EXPECT_TRUE((rotation.transpose() * rotation).isIdentity(1e-12));
    }
    const auto quaternions = continuous_quaternions(after);
    for (std::size_t w = 1; w < quaternions.size(); ++w)
      EXPECT_GE(quaternions[w].dot(quaternions[w - 1]), 0);
  }
}

TEST(Stretcher, LeavesAPathWithoutOrientationWithout) {
  Case each;
  each.path = without_orientation(each.path);
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_FALSE(result.path.has_orientation);
  EXPECT_TRUE(result.path.segments[0].waypoints[0].pose.linear().isIdentity(0));
}

TEST(Stretcher, GivesTheSameBytesForTheSameInput) {
  Case each;
  each.deformation = synthetic::bend(0.004, 0.200);
  const std::string first = tool_paths::tool_path_to_csv(each.run().path);
  EXPECT_GT(first.size(), 1000U);
  EXPECT_EQ(first, tool_paths::tool_path_to_csv(each.run().path));
}

TEST(AffineMethod, FindsTheScaleAndMovesThePathTheRightWay) {
  Case each;
  each.parameters.method = Method::kAffine;
  each.moved = synthetic::similarity(0.9, synthetic::random_rotation(5), {0.1, 0.2, 0.3});
  expect_adapted(each, 0.0002, 0.5 * kDegree);
}

TEST(AffineMethod, SaysWhereTheBestScaleIsAnEndOfTheRange) {
  Case each;
  each.parameters.method = Method::kAffine;
  each.parameters.scale_range = 0.002;
  each.scan.uneven = true;  // the principal axes are biased by more than the range
  expect_refused(each.run(), Reason::kScaleAtBound);
}

TEST(AffineMethod, IsRefusedWhereTheObjectIsBent) {
  Case each;
  each.parameters.method = Method::kAffine;
  each.deformation = synthetic::bend(0.006, 0.200);
  const StretchResult result = each.run();
  EXPECT_FALSE(result.verdict.accepted());
  EXPECT_TRUE(result.path.segments.empty());
}

TEST(Stretcher, InfersWaypointsOverASmallHoleAndFlagsThem) {
  Case each;
  each.scan.is_hole = [](const Eigen::Vector3d& at) {
    return at.y() < -0.05 && std::abs(at.x()) < 0.008;
  };
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_LE(each.error(result).max, 0.0003);
  const auto inferred = std::count_if(result.quality.begin(), result.quality.end(),
                                      [](const WaypointQuality& q) { return !q.measured; });
  EXPECT_GE(inferred, 2);
  EXPECT_LE(inferred, 8);
}

TEST(Stretcher, KeepsTheOrientationOverASlotOfTheReference) {
  constexpr double kHalfWidth = 0.0025;  // [m] lines that a camera lost
  Case each;
  each.reference_hole = [](const Eigen::Vector3d& at) {
    return std::abs(at.x() + 0.0875) < kHalfWidth && std::abs(at.y()) < 0.06;
  };
  expect_adapted(each, 0.0001, 1.0 * kDegree);
}

TEST(Stretcher, CanBeCancelledAtEveryStage) {
  const Case each;
  std::vector<std::string> stages;
  each.run([&stages](const std::string& stage, double) {
    stages.push_back(stage);
    return true;
  });
  ASSERT_GE(stages.size(), 5U);
  for (std::size_t stop = 0; stop < stages.size(); ++stop) {
    std::size_t calls = 0;
    const StretchResult result =
        each.run([&calls, stop](const std::string&, double) { return calls++ < stop; });
    expect_refused(result, Reason::kCancelled);
    EXPECT_EQ(calls, stop + 1);
  }
}

TEST(Stretcher, ReportsProgressThatOnlyRises) {
  double last = 0;
  const Case each;
  each.run([&last](const std::string&, double progress) {
    EXPECT_GE(progress, last);
    last = progress;
    return true;
  });
  EXPECT_EQ(last, 1);
}

TEST(StretchParameters, AreRefusedByName) {
  const Case each;
  StretchParameters parameters;
  parameters.max_scale = 0.1;
  EXPECT_THROW(check(parameters), scan_cell_common::InvalidParameter);
  parameters = {};
  parameters.leaf.y() = 0;
  EXPECT_THROW(check(parameters), scan_cell_common::InvalidParameter);
  parameters = {};
  parameters.tolerance = std::nan("");
  EXPECT_THROW(check(parameters), scan_cell_common::InvalidParameter);
  EXPECT_THROW(method_from_string("magic"), scan_cell_common::InvalidParameter);
}

TEST(Stretcher, FollowsAFloppySheetPushedUnderThePart) {
  Case each;
  each.part = each.scanned_part = synthetic::curved_panel();
  each.path = synthetic::path_on(each.part, kWaypoints);
  each.deformation = [](const Eigen::Vector3d& at) {
    const double away = std::hypot(at.x() - 0.03, at.y() - 0.02) / 0.05;
    return Eigen::Vector3d(0, 0, 0.004 * std::exp(-away * away));
  };
  expect_adapted(each, 0.0006, 1.0 * kDegree);
}

TEST(Stretcher, TakesASymmetricPartWhereThePathIsSymmetricToo) {
  Case each;
  each.part = each.scanned_part = synthetic::photo_frame(0);  // the path runs once around it
  each.path = synthetic::path_on(each.part, kWaypoints);
  for (Segment& segment : each.path.segments) {
    for (Waypoint& waypoint : segment.waypoints)
      waypoint.process_values.assign(each.path.process_names.size(), 0.05);
  }
  EXPECT_TRUE(each.run().verdict.accepted());
}

/// A plate of which two thirds are nearly square: its principal axes rotate if a third is missing.
synthetic::Part ribbed_plate() {
  synthetic::Part part;
  part.width = 0.24;
  part.depth = 0.16;
  part.inside = [](double, double) { return true; };
  part.height = [](double x, double y) {
    const bool rib = std::abs(x + 0.06) < 0.004 || std::abs(x + 0.02) < 0.004;
    const bool boss = std::hypot(x + 0.09, y - 0.04) < 0.012;
    return (rib && std::abs(y) < 0.06) || boss ? 0.009 : 0.0;
  };
  part.path_position = [](double a) { return Eigen::Vector3d(-0.04, -0.05 + 0.1 * a, 0); };
  return part;
}

TEST(Stretcher, FindsAPlateOfWhichAThirdWasNotScanned) {
  Case each;
  each.part = each.scanned_part = ribbed_plate();
  each.path = synthetic::path_on(each.part, kWaypoints);
  each.scan.is_hole = [](const Eigen::Vector3d& at) { return at.x() > 0.04; };
  for (const double degrees : {60.0, 140.0, 200.0, 290.0}) {
    const Eigen::Vector3d axis = Eigen::Vector3d(0.3, -0.5, degrees / 100).normalized();
    each.moved = synthetic::similarity(
        1.2, Eigen::AngleAxisd(degrees * kDegree, axis).toRotationMatrix(), {0.4, -0.2, 0.1});
    expect_adapted(each, 0.0003, 1 * kDegree);
  }
}
