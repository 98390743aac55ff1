// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>

#include "scan_cell_common/errors/errors.h"
#include "synthetic_parts.h"
#include "tool_path_stretcher/stretcher.h"

using namespace tool_path_stretcher;

TEST(Resampling, HasOneRangeOfSpacings) {
  for (const double good : {0., 1e-6, 0.004, 10.}) {
    StretchParameters parameters;
    parameters.resample_spacing = good;
    EXPECT_NO_THROW(check(parameters)) << good;
  }
  for (const double bad : {-0.004, 1e-7, 10.1, std::nan("")}) {
    StretchParameters parameters;
    parameters.resample_spacing = bad;
    EXPECT_THROW(check(parameters), scan_cell_common::InvalidParameter) << bad;
  }
  try {
    StretchParameters parameters;
    parameters.resample_spacing = 1e-7;
    check(parameters);
    FAIL();
  } catch (const scan_cell_common::InvalidParameter& error) {
    EXPECT_STREQ(error.what(), "resample_spacing: 1e-07; give a value from 1e-06 to 10, or 0");
  }
}

TEST(Resampling, IsDoneBeforeThePathIsAdapted) {
  const synthetic::Part part = synthetic::curved_panel();
  synthetic::Scan scan;
  StretchParameters parameters;
  parameters.resample_spacing = 0.004;
  const ToolPath path = synthetic::path_on(part, 50);
  const Surface surface = surface_from_cloud(
      synthetic::scan(part, {}, synthetic::no_deformation(), scan), parameters.leaf, "panel");
  const StretchResult result = stretch(surface, surface, path, parameters);
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_EQ(result.path.segments[0].waypoints.size(),
            resampled(path, 0.004).segments[0].waypoints.size());
  EXPECT_EQ(result.quality.size(), waypoint_count(result.reference_path));
}

/// Expects that a path lifted off the panel by `height` [m] (a function of the share along the
/// path) is `expected` [m] off the panel scaled by 1.5.
void expect_stand_off(StandOff stand_off, const std::function<double(double)>& height,
                      const std::function<double(double)>& expected) {
  const synthetic::Part part = synthetic::curved_panel();
  const Similarity moved = synthetic::similarity(1.5, synthetic::random_rotation(4), {0, 0.1, 0.2});
  const ToolPath touching = synthetic::path_on(part, 50);
  const auto share = [](std::size_t i, const Segment& segment) {
    return static_cast<double>(i) / static_cast<double>(segment.waypoints.size());
  };
  ToolPath path = touching;
  for (Segment& segment : path.segments) {
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
      Eigen::Isometry3d& pose = segment.waypoints[i].pose;
      pose.translation() += height(share(i, segment)) * pose.linear().col(2);
    }
  }
  StretchParameters parameters;
  parameters.stand_off = stand_off;
  const auto surface = [&](const Similarity& similarity, unsigned seed) {
    synthetic::Scan how;
    how.seed = seed;
    return surface_from_cloud(synthetic::scan(part, similarity, synthetic::no_deformation(), how),
                              parameters.leaf, "panel");
  };
  const StretchResult result = stretch(surface({}, 11), surface(moved, 1), path, parameters);
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  const Segment below =
      synthetic::truth(touching, moved, synthetic::no_deformation()).segments.at(0);
  for (std::size_t i = 0; i < below.waypoints.size(); ++i) {
    const Eigen::Isometry3d& foot = below.waypoints[i].pose;
    const Eigen::Vector3d at = result.path.segments.at(0).waypoints[i].pose.translation();
    EXPECT_NEAR(foot.linear().col(2).dot(at - foot.translation()), expected(share(i, below)),
                0.0003);
  }
}

TEST(StandOff, StaysAsLongAsItIs) {
  const auto even = [](double) { return 0.008; };
  expect_stand_off(StandOff::kKeep, even, even);
}

TEST(StandOff, GrowsWithThePartWhereThatIsWanted) {
  expect_stand_off(
      StandOff::kScale, [](double) { return 0.008; }, [](double) { return 1.5 * 0.008; });
}

TEST(StandOff, IsNoneOfAWayThroughTheAirWhichGrowsWithThePart) {
  const auto rising = [](double share) { return 0.004 + 0.010 * share; };
  expect_stand_off(StandOff::kKeep, rising, [&](double share) { return 1.5 * rising(share); });
}
