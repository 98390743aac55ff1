// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "placement/corrections.h"
#include "stretch_case.h"

using namespace tool_path_stretcher;

namespace {

/// Two planes that meet at a ridge with a fold of 40 degrees, and a flat end that shows the
/// position along it. The path runs back and forth across the ridge.
Part roof() {
  const double steep = std::tan(20 * kDegree);
  Part part;
  part.width = 0.2;
  part.depth = 0.12;
  part.inside = [](double x, double y) {
    return std::abs(x) <= 0.1 && std::abs(y) <= 0.06 && !(x > 0.06 && y > 0.02);
  };
  part.height = [steep](double, double y) { return 0.03 - steep * std::abs(y); };
  part.path_position = [height = part.height](double a) {
    const double x = 0.15 * (a - 0.5);
    const double y = 0.012 * std::sin(24 * M_PI * a + 0.1);
    return Eigen::Vector3d(x, y, height(x, y));
  };
  return part;
}

/// [rad] of each waypoint
std::vector<double> turned_by(const StretchResult& result, const ToolPath& truth) {
  std::vector<double> angles;
  for (std::size_t s = 0; s < truth.segments.size(); ++s) {
    for (std::size_t w = 0; w < truth.segments[s].waypoints.size(); ++w) {
      const Eigen::Matrix3d is = result.path.segments.at(s).waypoints.at(w).pose.linear();
      const Eigen::Matrix3d should = truth.segments[s].waypoints[w].pose.linear();
      angles.push_back(Eigen::AngleAxisd(is.transpose() * should).angle());
    }
  }
  return angles;
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values)
    sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

constexpr double kWidth = 0.006;  // [m]

/// A waypoint on a flat part that shows a slope, as on the flank of a dent. Its height is the rise
/// of the slope over one width.
Station station(double slope, bool measured = true) {
  Station result{};
  result.in_air = false;
  result.surface.measured = measured;
  result.surface.normal = result.normal = Eigen::Vector3d::UnitZ();
  result.surface.slope = (measured ? slope : 0) * Eigen::Vector3d::UnitX();
  result.surface.height = kWidth * (measured ? slope : 0);
  result.surface.slope_variance = measured ? std::pow(0.01, 2) : 0;
  result.turn.setIdentity();
  result.turn_covariance = std::pow(0.001, 2) * Eigen::Matrix3d::Identity();
  return result;
}

Track track_of(const std::vector<Station>& stations) {
  Track track{stations, {}};
  for (std::size_t i = 0; i < stations.size(); ++i)
    track.arc_length.push_back(0.001 * static_cast<double>(i));
  return track;
}

}  // namespace

TEST(Orientation, OfAMovedPartTurnsByThePosesRotationAloneAlsoBesideAnEdge) {
  Case each;
  each.part = each.scanned_part = roof();
  each.path = synthetic::path_on(each.part, kWaypoints);
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  const auto angles = turned_by(result, synthetic::truth(each.path, each.moved, each.deformation));
  EXPECT_LT(root_mean_square(angles), 0.2 * kDegree);
  EXPECT_LT(*std::max_element(angles.begin(), angles.end()), 1 * kDegree);
}

TEST(Orientation, FollowsADent) {
  Case each;
  each.part = each.scanned_part = synthetic::curved_panel();
  each.path = synthetic::path_on(each.part, kWaypoints);
  const Eigen::Vector3d at = each.path.segments[0].waypoints[kWaypoints / 4].pose.translation();
  each.deformation = [at](const Eigen::Vector3d& point) {
    const double away = (point - at).head<2>().norm() / 0.015;
    return Eigen::Vector3d(0, 0, -0.0025 * std::exp(-away * away));
  };
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  // On the dent's flank the surface is tilted by up to 8 degrees.
  const auto angles = turned_by(result, synthetic::truth(each.path, each.moved, each.deformation));
  EXPECT_LT(*std::max_element(angles.begin(), angles.end()), 4 * kDegree);
}

TEST(Orientation, OfAPathWithoutAnyHasNoExpectedError) {
  Case each;
  each.path = without_orientation(each.path);
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  for (const WaypointQuality& quality : result.quality)
    EXPECT_TRUE(std::isnan(quality.expected_error_orientation));
}

TEST(Orientation, ThatIsNotKnownWellEnoughRefusesThePathAndNamesTheWaypoints) {
  Case each;
  each.deformation = synthetic::bend(0.004, 0.200);
  const StretchResult before = each.run();
  ASSERT_TRUE(before.verdict.accepted()) << before.verdict.message;
  std::vector<double> expected;
  for (const WaypointQuality& quality : before.quality)
    expected.push_back(quality.expected_error_orientation);
  std::sort(expected.begin(), expected.end());
  each.parameters.max_orientation_error = expected.at(expected.size() - 11);
  const StretchResult result = each.run();
  expect_refused(result, Reason::kOrientationUncertain);
  EXPECT_EQ(result.verdict.waypoints.size(), 10U);
  EXPECT_NE(result.verdict.message.find("max_orientation_error"), std::string::npos);
}

TEST(Tilts, OfASlopeThatNeighboursShowAreFollowed) {
  const Track track = track_of(std::vector<Station>(9, station(0.2)));
  for (const Tilt& tilt : tilts_along(track, kWidth, {}, true)) {
    EXPECT_NEAR(tilt.slope.x(), 0.2, 0.02);
    EXPECT_LT(std::sqrt(tilt.variance), 0.02);
  }
}

TEST(Tilts, OfASurfaceThatIsTiltedButNotMovedAreNotFollowedAndDoubtedALittle) {
  Station rounded_off = station(0.2);
  rounded_off.surface.height /= 5;
  const Track track = track_of(std::vector<Station>(9, rounded_off));
  for (const Tilt& tilt : tilts_along(track, kWidth, {}, true)) {
    EXPECT_LT(tilt.slope.norm(), 0.005);
    EXPECT_NEAR(std::sqrt(2 * tilt.variance), 0.1 * 0.2, 0.01);
  }
}

TEST(Tilts, OfASlopeThatOneWaypointAloneShowsAreNotFollowed) {
  std::vector<Station> stations(9, station(0, false));
  stations[4] = station(0.6);
  const std::vector<Tilt> tilts = tilts_along(track_of(stations), kWidth, {}, true);
  for (const Tilt& tilt : tilts)
    EXPECT_LT(tilt.slope.norm(), 0.01);
}

TEST(Tilts, AreNotThoseOfTheFaceBeyondAnEdge) {
  std::vector<Station> stations(9, station(0.2));
  for (std::size_t i = 5; i < stations.size(); ++i) {
    stations[i] = station(0);
    stations[i].surface.normal = Eigen::Vector3d(0, 1, 1).normalized();
  }
  const std::vector<Tilt> tilts = tilts_along(track_of(stations), kWidth, {}, true);
  EXPECT_NEAR(tilts[4].slope.x(), 0.2, 0.02);
  EXPECT_NEAR(tilts[5].slope.norm(), 0, 1e-9);
}

TEST(Tilts, ThatAreNotFollowedAreAnErrorThatIsLeft) {
  const Track track = track_of(std::vector<Station>(9, station(0.2)));
  for (const Tilt& tilt : tilts_along(track, kWidth, {}, false)) {
    EXPECT_TRUE(tilt.slope.isZero());
    EXPECT_NEAR(std::sqrt(2 * tilt.variance), 0.2, 0.02);
  }
}
