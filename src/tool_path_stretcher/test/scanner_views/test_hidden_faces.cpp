// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scanner_views/blocks.h"
#include "scanner_views/parts/mesh_builder.h"
#include "sight/seeable.h"
#include "tool_path_stretcher/stretcher.h"

using namespace scanner_views;
using namespace tool_path_stretcher;
using Eigen::Vector3d;

namespace {

constexpr std::size_t kOnTop = 36;   // waypoints 1 mm apart
constexpr std::size_t kOnWall = 18;  // below them, also 1 mm apart

/// Over the upper block of step(), and down its wall towards -x.
ToolPath path_over_the_edge() {
  ToolPath path;
  path.segments.emplace_back();
  const auto add = [&](double x, double z) {
    Waypoint waypoint;
    waypoint.pose = Eigen::Isometry3d::Identity();
    waypoint.pose.translation() = Vector3d(x, 0.007, z);
    path.segments.front().waypoints.push_back(waypoint);
  };
  for (std::size_t i = 0; i < kOnTop; ++i)
    add(0.016 - 1e-3 * static_cast<double>(i), 0.04);
  for (std::size_t i = 1; i <= kOnWall; ++i)
    add(-0.02, 0.04 - 1e-3 * static_cast<double>(i));
  return path;
}

/// A scan of step() from the +x side, without the wall towards -x.
StretchResult stretched(double max_hole_distance) {
  StretchParameters parameters;
  parameters.max_hole_distance = max_hole_distance;
  PosePrior prior;  // the part has a 180 degree symmetry
  parameters.prior.pose = prior;
  const Surface reference = surface_from_mesh(to_polygon_mesh(step()), parameters.leaf, "mesh");
  const Points from = {Vector3d(1, 0, 1).normalized()};
  const Surface object =
      surface_from_cloud(seeable_part(reference, from).points, parameters.leaf, "scan", from);
  return stretch(reference, object, path_over_the_edge(), parameters);
}

}  // namespace

TEST(HiddenFaces, WithAPathFarFromTheScanAreRefusedWithAllItsWaypoints) {
  const StretchResult result = stretched(0.01);
  ASSERT_EQ(result.verdict.reason, Reason::kPathNotScanned) << result.verdict.message;
  std::vector<std::size_t> deep;  // more than 10 mm below the edge, where the scan ends
  for (std::size_t i = kOnTop + 11; i < kOnTop + kOnWall; ++i)
    deep.push_back(i);
  std::vector<std::size_t> named = result.verdict.waypoints;
  ASSERT_GE(named.size(), deep.size());
  EXPECT_LE(named.size(), deep.size() + 2);
  named.erase(named.begin(), named.end() - static_cast<std::ptrdiff_t>(deep.size()));
  EXPECT_EQ(named, deep);
}

TEST(HiddenFaces, AreNotMeasuredByTheScanOfTheirEdge) {
  const StretchResult result = stretched(0.03);
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  for (std::size_t i = 0; i < result.quality.size(); ++i) {
    SCOPED_TRACE(i);
    const auto below = static_cast<double>(i) - static_cast<double>(kOnTop) + 1;  // [mm]
    if (below < -5) {
      EXPECT_TRUE(result.quality[i].measured);
    }
    if (below < 6) continue;
    EXPECT_FALSE(result.quality[i].measured);
    EXPECT_NEAR(result.quality[i].hole, 1e-3 * below, 2e-3);
  }
}
