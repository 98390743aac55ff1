// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scan_cell_sim/scene.h"
#include "scanner_views/blocks.h"
#include "scanner_views/parts/extrusion.h"
#include "scanner_views/parts/part_list.h"
#include "scanner_views/parts/path_on_part.h"

using namespace scanner_views;
using Eigen::Vector3d;

namespace {

/// Whether every edge belongs to one triangle and, in the opposite direction, to another.
bool is_closed(const Mesh& mesh) {
  using Key = std::array<long, 6>;  // [um] both ends
  const auto rounded = [](double metres) { return std::lround(1e6 * metres); };
  std::map<Key, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d &a = mesh.vertices[triangle[i]], &b = mesh.vertices[triangle[(i + 1) % 3]];
      const Key there = {rounded(a.x()), rounded(a.y()), rounded(a.z()),
                         rounded(b.x()), rounded(b.y()), rounded(b.z())};
      const Key back = {there[3], there[4], there[5], there[0], there[1], there[2]};
      ++edges[there];
      --edges[back];
    }
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& each) { return each.second == 0; });
}

std::vector<ViewPart> all_parts(std::uint64_t seed) {
  Draws draws(seed);
  std::vector<ViewPart> parts = plate_parts(draws);
  for (const auto& more : {profile_parts(draws), curved_parts(draws), symmetric_parts(draws)})
    parts.insert(parts.end(), more.begin(), more.end());
  return parts;
}

}  // namespace

TEST(ViewParts, SolidsHaveTheVolumeWorkedOutByHand) {
  EXPECT_NEAR(volume_of(step()), 0.1 * 0.1 * 0.01 + 0.04 * 0.06 * 0.03, 1e-12);
  const Terrace drilled{cases::rectangle_loop(0.1, 0.1), 0.02, {hole({0.01, 0.02}, 0.01)}};
  const double polygon = 32 * std::sin(2 * M_PI / 32) / 2 * 0.01 * 0.01;  // of 32 corners
  EXPECT_NEAR(volume_of(solid_of(drilled)), (0.1 * 0.1 - polygon) * 0.02, 1e-12);
  const Extrusion bar{cases::rectangle_loop(0.02, 0.03), 0.2, 0.5, -0.3};
  EXPECT_NEAR(volume_of(solid_of(bar)), 0.02 * 0.03 * 0.2, 1e-12);
}

TEST(ViewParts, AreClosedAndTurnedOutwardsButForSheets) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    for (const ViewPart& part : all_parts(seed)) {
      if (part.name == "wavy sheet") continue;
      EXPECT_TRUE(is_closed(part.mesh)) << part.name << ", seed " << seed;
      EXPECT_GT(volume_of(part.mesh), 0) << part.name << ", seed " << seed;
    }
  }
}

TEST(ViewParts, StayClosedAndAsLargeWhenTheirEdgesAreHalved) {
  const Mesh coarse = step(), fine = refined(coarse, 0.004);
  EXPECT_TRUE(is_closed(fine));
  EXPECT_NEAR(volume_of(fine), volume_of(coarse), 1e-12);
  for (const auto& [a, b, c] : fine.triangles) {
    EXPECT_LE((fine.vertices[a] - fine.vertices[b]).norm(), 0.004);
    EXPECT_LE((fine.vertices[b] - fine.vertices[c]).norm(), 0.004);
    EXPECT_LE((fine.vertices[c] - fine.vertices[a]).norm(), 0.004);
  }
}

TEST(ViewParts, PathsLieOnThem) {
  Draws draws(5);
  for (const ViewPart& part : all_parts(1)) {
    const scan_cell_sim::Scene scene({part.mesh}, 1);
    for (const PathKind kind : {PathKind::kRaster, PathKind::kRim, PathKind::kWave}) {
      const ToolPath path = path_on(part.mesh, kind, draws);
      for (const auto& segment : path.segments) {
        for (const auto& waypoint : segment.waypoints)
          EXPECT_LT(scene.distance_to_surface(waypoint.pose.translation()), 1e-6) << part.name;
      }
    }
  }
}
