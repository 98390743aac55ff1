// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report.h"
#include "stretch_case.h"

using namespace tool_path_stretcher;
using Eigen::Vector3d;

namespace {

/// [m] constant height at which a raster crosses places without a surface.
constexpr double kBridge = 0.04;

/// A crowned sheet of 1.2 x 0.42 m with two windows and a notch in its rim, like those that are
/// sanded.
Part sheet_with_openings() {
  Part part;
  part.width = 1.2;
  part.depth = 0.42;
  part.inside = [](double x, double y) {
    if (std::abs(x) > 0.6 || std::abs(y) > 0.21) return false;
    const bool window = x > -0.45 && x < -0.15 && std::abs(y + 0.02) < 0.11;
    const bool other = std::hypot(x - 0.22, y - 0.03) < 0.10;
    const bool notch = x > 0.45 && y > 0.12;
    return !window && !other && !notch;
  };
  part.height = [](double x, double y) {
    return 0.05 - 0.12 * x * x - 0.3 * y * y + 0.02 * x * y + 0.006 * std::sin(9 * x + 4 * y);
  };
  return part;
}

/// A path, and which of its waypoints have no surface beside them.
struct AirPath {
  ToolPath path;
  std::vector<bool> in_air;

  void add(const Vector3d& at, const Part& part, bool is_in_air) {
    Waypoint waypoint;
    waypoint.pose.translation() = at;
    const Vector3d normal = is_in_air ? Vector3d(0, 0, 1) : part.normal(at.x(), at.y());
    waypoint.pose.linear() =
        Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), normal).toRotationMatrix();
    path.segments.back().waypoints.push_back(waypoint);
    in_air.push_back(is_in_air);
  }
};

/// [m] Beyond this, no waypoint of raster() counts as on the surface; nearer than a third of it,
/// none is in the air. 10 mm lies in between.
constexpr double kClear = 0.033;

double from_surface(const Part& part, const Vector3d& at) {
  constexpr double kStep = 0.004;  // [m]
  double least = 10;
  for (double x = -part.width / 2; x <= part.width / 2; x += kStep) {
    for (double y = -part.depth / 2; y <= part.depth / 2; y += kStep) {
      if (part.inside(x, y))
        least = std::min(least, (Vector3d(x, y, part.height(x, y)) - at).norm());
    }
  }
  return least;
}

/// Lines over the sheet, across its openings and past its rim, each with approach and retract.
AirPath raster(const Part& part, double step = 0.05) {
  AirPath result;
  result.path.name = "raster";
  result.path.has_orientation = true;
  for (const double y : {-0.17, -0.08, 0.0, 0.07, 0.165}) {
    result.path.segments.push_back({"line", {}});
    result.add({-0.585, y, part.height(-0.585, y) + 0.15}, part, true);
    for (double x = -0.585; x < 0.68; x += step) {
      const Vector3d on(x, y, part.height(x, y));
      if (part.inside(x, y)) {
        result.add(on, part, false);
        continue;
      }
      const Vector3d over = on + kBridge * Vector3d::UnitZ();
      result.add(over, part, true);
    }
    result.add({0.7, y, part.height(0.6, y) + 0.2}, part, true);
  }
  return result;
}

Case sheet_case() {
  Case each;
  each.part = each.scanned_part = sheet_with_openings();
  each.scan.points = 40000;
  each.path = raster(each.part).path;
  return each;
}

std::vector<bool> said_in_air(const StretchResult& result) {
  std::vector<bool> flags;
  for (const WaypointQuality& quality : result.quality)
    flags.push_back(quality.in_air);
  return flags;
}

/// [m] of each waypoint from the truth.
std::vector<double> errors_of(const StretchResult& result, const Case& each) {
  const Points is = positions_of(result.path);
  const Points should = positions_of(synthetic::truth(each.path, each.moved, each.deformation));
  std::vector<double> errors;
  for (std::size_t i = 0; i < is.size(); ++i)
    errors.push_back((is[i] - should[i]).norm());
  return errors;
}

double expected_error(const WaypointQuality& quality) {
  return std::hypot(quality.expected_error_normal, quality.expected_error_tangential);
}

std::size_t count_of(const std::vector<bool>& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), true));
}

}  // namespace

TEST(Air, TheTestsPathIsClearlyOnTheSurfaceOrOffIt) {
  const Part part = sheet_with_openings();
  const AirPath path = raster(part);
  const Points at = positions_of(path.path);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double far = from_surface(part, at[i]);
    EXPECT_EQ(far > kClear, path.in_air[i]) << at[i].transpose();
    EXPECT_EQ(far < kClear / 3, !path.in_air[i]) << at[i].transpose();
  }
  EXPECT_GE(count_of(path.in_air), 30U);
  EXPECT_LE(2 * count_of(path.in_air), at.size());
}

TEST(Air, OverOpeningsPastTheRimAndAboveThePartIsCarriedAndMarked) {
  const Case each = sheet_case();
  const AirPath path = raster(each.part);
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_EQ(said_in_air(result), path.in_air);
  EXPECT_LT(each.error(result).max, 0.0006);
  EXPECT_LT(each.error(result).orientation, 0.3 * kDegree);
  const std::string counts = std::to_string(count_of(path.in_air)) + " of " +
                             std::to_string(path.in_air.size()) + " waypoints are in the air";
  EXPECT_NE(result.verdict.message.find(counts), std::string::npos) << result.verdict.message;
  for (const WaypointQuality& quality : result.quality) {
    if (!quality.in_air) continue;
    EXPECT_FALSE(quality.measured);
    EXPECT_FALSE(quality.position_measured);
  }
}

TEST(Air, OfABentPartFollowsTheBendAsFarAsItsExpectedErrorsSay) {
  Case each = sheet_case();
  const double rise = 0.006 * each.part.width;
  each.deformation = synthetic::bend(rise, each.part.width);
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_GT(result.deformation_nodes, 0U);
  const std::vector<double> errors = errors_of(result, each);
  const Points at = positions_of(each.path);
  const double steepest = 4 * rise / each.part.width;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (!result.quality[i].in_air) {
      EXPECT_LT(errors[i], 0.002) << i;  // the bend stretches the crown by up to 0.3 %
      continue;
    }
    EXPECT_LT(errors[i], 3 * expected_error(result.quality[i])) << i;
    // The surface leans. Anything attached to it leans with it; anything lifted only by the bend
    // does not.
    EXPECT_LT(errors[i], 0.0015 + 1.2 * steepest * from_surface(each.part, at[i])) << i;
  }
}

TEST(Air, NeedsNoScanAndTheSurfaceDoes) {
  Case each = sheet_case();
  each.scan.is_hole = [](const Vector3d& at) { return at.x() < -0.45 && at.y() > 0.1; };
  ToolPath& path = each.path;
  path.segments.resize(3);  // y up to 0
  path.segments.push_back({"above what was not scanned", {}});
  Waypoint above;
  above.pose.translation() = Vector3d(-0.53, 0.16, 0.3);
  path.segments.back().waypoints = {above};
  const StretchResult accepted = each.run();
  ASSERT_TRUE(accepted.verdict.accepted()) << accepted.verdict.message;
  EXPECT_TRUE(accepted.quality.back().in_air);

  const Vector3d at(-0.53, 0.16, each.part.height(-0.53, 0.16));
  path.segments.back().waypoints[0].pose.translation() = at;
  const StretchResult refused = each.run();
  expect_refused(refused, Reason::kPathNotScanned);
  EXPECT_EQ(refused.verdict.waypoints, std::vector<std::size_t>{waypoint_count(path) - 1});
}

TEST(Air, MayBeHalfOfAPathThoughNotAllOfTheRestIsMeasured) {
  Case each = sheet_case();
  const Vector3d hole = each.path.segments[0].waypoints[3].pose.translation();
  each.scan.is_hole = [hole](const Vector3d& at) { return (at - hole).norm() < 0.008; };
  Waypoint above;
  above.pose.translation() = Vector3d(0, 0, 0.3);
  const std::size_t more = waypoint_count(each.path) - 2 * count_of(raster(each.part).in_air);
  each.path.segments.push_back({"above", std::vector<Waypoint>(more, above)});
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  const QualitySummary summary = summary_of(result.quality);
  EXPECT_EQ(2 * summary.in_air, waypoint_count(each.path));
  EXPECT_GT(summary.inferred, 0U);
}

TEST(Air, TheExpectedErrorGrowsWithTheDistance) {
  Case each = sheet_case();
  each.deformation = synthetic::bend(0.006 * each.part.width, each.part.width);
  Segment retract{"retract", {}};
  for (const double height : {0.06, 0.15, 0.4, 1.0}) {
    Waypoint waypoint;
    waypoint.pose.translation() = Vector3d(0, 0, each.part.height(0, 0) + height);
    retract.waypoints.push_back(waypoint);
  }
  each.path.segments.push_back(retract);
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  const std::size_t first = result.quality.size() - retract.waypoints.size();
  for (std::size_t i = first + 1; i < result.quality.size(); ++i)
    EXPECT_GT(expected_error(result.quality[i]), 1.2 * expected_error(result.quality[i - 1]));
}

TEST(Air, IsInTheReportAndInTheLineForAPerson) {
  const Case each = sheet_case();
  const StretchResult result = each.run();
  const std::size_t in_air = count_of(raster(each.part).in_air);
  const auto report = nlohmann::json::parse(report_to_json(result));
  EXPECT_EQ(report["waypoints_in_air"], in_air);
  EXPECT_EQ(report["measured_waypoints"].get<std::size_t>() +
                report["inferred_waypoints"].get<std::size_t>() + in_air,
            waypoint_count(each.path));
  EXPECT_EQ(report["quality"][0]["in_air"], true);
  EXPECT_EQ(report["quality"][1]["in_air"], false);
  const std::string file = testing::TempDir() + "air_report.json";
  save_report(file, result);
  const std::vector<std::size_t> read = load_report(file).in_air;
  std::vector<bool> flags(waypoint_count(each.path), false);
  for (const std::size_t i : read)
    flags.at(i) = true;
  EXPECT_EQ(flags, said_in_air(result));
  const std::string line = to_string(summary_of(result.quality));
  EXPECT_NE(line.find(std::to_string(in_air) + " in the air"), std::string::npos) << line;
}

TEST(Air, IsRefusedWhereItIsMostOfThePath) {
  Case each = sheet_case();
  const std::size_t on = waypoint_count(each.path);
  Segment away{"away", {}};
  for (std::size_t i = 0; i < on; ++i) {
    Waypoint waypoint;
    waypoint.pose.translation() = Vector3d(-0.5 + 0.01 * static_cast<double>(i), 0.8, 0.2);
    away.waypoints.push_back(waypoint);
  }
  each.path.segments.push_back(away);
  const StretchResult result = each.run();
  expect_refused(result, Reason::kPathOffReference);
  const std::size_t off = on + count_of(raster(each.part).in_air);
  EXPECT_EQ(result.verdict.waypoints.size(), off);
  const std::string counts = std::to_string(off) + " of " + std::to_string(2 * on) + " waypoints";
  for (const std::string& said : {counts, std::string("max_stand_off (20 mm)")})
    EXPECT_NE(result.verdict.message.find(said), std::string::npos) << result.verdict.message;
}

TEST(Air, APathInMillimetresThatLeadsThroughTheAirIsSaidToBe) {
  Case each = sheet_case();
  for (Segment& segment : each.path.segments) {
    for (Waypoint& waypoint : segment.waypoints)
      waypoint.pose.translation() *= 1000;
  }
  const StretchResult result = each.run();
  expect_refused(result, Reason::kUnusableInput);
  EXPECT_NE(result.verdict.message.find("--path-units mm"), std::string::npos)
      << result.verdict.message;
}

TEST(Air, OfAnotherPartsPathIsRefused) {
  Case each;  // a frame of 0.2 m
  each.path = raster(sheet_with_openings()).path;
  expect_refused(each.run(), Reason::kPathOffReference);
}

TEST(Air, BeyondAnyRobotsReachIsRefused) {
  Case each;
  each.path.segments[1].waypoints.back().pose.translation().z() += 11;
  const StretchResult result = each.run();
  expect_refused(result, Reason::kPathOffReference);
  EXPECT_EQ(result.verdict.waypoints, std::vector<std::size_t>{kWaypoints - 1});
}

/// The path of a panel, led over it at a stand-off.
Case led_over(double stand_off) {
  Case each;
  each.part = each.scanned_part = synthetic::curved_panel();
  each.path = synthetic::path_on(each.part, kWaypoints);
  for (Segment& segment : each.path.segments) {
    for (Waypoint& waypoint : segment.waypoints)
      waypoint.pose.translation() += stand_off * waypoint.pose.linear().col(2);
  }
  return each;
}

TEST(Air, IsNotWhereATorchIsLedOverTheSurfaceAtDistancesThatChange) {
  Case each = led_over(0);
  std::size_t number = 0;
  for (Segment& segment : each.path.segments) {
    for (Waypoint& waypoint : segment.waypoints) {
      const double height = 0.006 + 0.005 * (1 + std::sin(0.1 * static_cast<double>(number++)));
      waypoint.pose.translation() += height * waypoint.pose.linear().col(2);
    }
  }
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_EQ(count_of(said_in_air(result)), 0U);
}

TEST(Air, IsNotWhereASegmentIsLedOverTheSurface) {
  const StretchResult near = led_over(0.015).run();
  ASSERT_TRUE(near.verdict.accepted()) << near.verdict.message;
  EXPECT_EQ(count_of(said_in_air(near)), 0U);

  Case spray = led_over(0.2);
  expect_refused(spray.run(), Reason::kPathOffReference);
  spray.parameters.max_stand_off = 0.25;
  const StretchResult far = spray.run();
  ASSERT_TRUE(far.verdict.accepted()) << far.verdict.message;
  EXPECT_EQ(count_of(said_in_air(far)), 0U);
  const Case touching = led_over(0);
  const Points on =
      positions_of(synthetic::truth(touching.path, touching.moved, synthetic::no_deformation()));
  const Points at = positions_of(far.path);
  for (std::size_t i = 0; i < on.size(); ++i)
    EXPECT_NEAR((at[i] - on[i]).norm(), 0.2, 0.001) << "kept, though the part is 8 % larger";
}
