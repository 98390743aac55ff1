// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "alignment/seeable_overlap.h"
#include "scanner_views/blocks.h"
#include "scanner_views/parts/mesh_builder.h"

using namespace scanner_views;
using namespace tool_path_stretcher;
using Eigen::Vector3d;

namespace {

constexpr double kSide = 0.1, kHeight = 0.015, kInlier = 0.001;  // [m]
constexpr double kTop = kSide * kSide;
constexpr double kWalls = 4 * kSide * kHeight;

/// A plate with half of its underside open.
Surface open_plate() {
  Mesh mesh = block(kSide, kSide, kHeight);
  const auto is_underside = [&mesh](const auto& triangle) {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&mesh](auto corner) { return mesh.vertices[corner].z() < 1e-6; });
  };
  mesh.triangles.erase(std::find_if(mesh.triangles.begin(), mesh.triangles.end(), is_underside));
  return surface_of(mesh);
}

Surface scanned_top() {
  constexpr double kHalf = kSide / 2;
  MeshBuilder builder;
  builder.quad({-kHalf, -kHalf, kHeight}, {kHalf, -kHalf, kHeight}, {kHalf, kHalf, kHeight},
               {-kHalf, kHalf, kHeight});
  return surface_of(builder.take());
}

class SeeableOverlap : public testing::Test {
 protected:
  const Surface plate_ = open_plate();
  Surface top_ = scanned_top();

  double overlap() const { return seeable_overlap({plate_, top_}, Mapping{}, kInlier); }
};

}  // namespace

TEST_F(SeeableOverlap, CountsNoUndersideAgainstAScanFromAbove) {
  ASSERT_FALSE(plate_.closed);
  const double whole = explain({plate_, top_}, Mapping{}, kInlier).overlap;
  EXPECT_NEAR(whole, kTop / (1.5 * kTop + kWalls), 0.05);
  top_.seen_from = {Vector3d::UnitZ()};
  EXPECT_NEAR(overlap(), kTop / (kTop + kWalls), 0.05);
}

TEST_F(SeeableOverlap, TakesTheSideThatShowsMoreWhereNobodySaysWhichWasSeen) {
  top_.seen_from.clear();
  EXPECT_NEAR(overlap(), kTop / (kTop + kWalls), 0.05);
}

TEST_F(SeeableOverlap, FromTheOtherSideIsOfWhatShowsThroughTheOpening) {
  top_.seen_from = {-Vector3d::UnitZ()};
  EXPECT_NEAR(overlap(), kTop / 2 / (kTop + kWalls), 0.05);
}
