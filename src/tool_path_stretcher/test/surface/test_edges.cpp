// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "surface/edges.h"
#include "tool_path_stretcher/stretcher.h"

using namespace tool_path_stretcher;
using Eigen::Vector3d;

namespace {

constexpr double kHalfLength = 0.1;  // [m] of the bar
constexpr double kHalfWidth = 0.03;  // [m]

/// A bar along x whose upper side leans and bulges to one side, so that no rotation maps it onto
/// itself.
double height(double y) {
  return 0.02 + 0.1 * y + 0.004 * std::exp(-std::pow((y - 0.012) / 0.006, 2));
}

/// Points 1 mm apart with 0.02 mm of noise.
class Bar {
 public:
  Points upper_side() {
    Points points;
    for (double x = -kHalfLength; x <= kHalfLength; x += 1e-3) {
      for (double y = -kHalfWidth; y <= kHalfWidth; y += 1e-3)
        points.push_back(noisy({x, y, height(y)}));
    }
    return points;
  }

  Points end_walls() {
    Points points;
    for (const double x : {-kHalfLength, kHalfLength}) {
      for (double y = -kHalfWidth; y <= kHalfWidth; y += 1e-3) {
        for (double z = 0; z < height(y); z += 1e-3)
          points.push_back(noisy({x, y, z}));
      }
    }
    return points;
  }

 private:
  Vector3d noisy(const Vector3d& point) {
    return point + Vector3d(noise_(random_), noise_(random_), noise_(random_));
  }

  std::mt19937 random_{7};
  std::normal_distribution<double> noise_{0, 2e-5};
};

Points both(Points one, const Points& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

Surface surface_of(const Points& points) {
  return surface_from_cloud(points, StretchParameters().leaf, "cloud");
}

/// How many of the edges at the +x end of the bar face this way.
std::size_t facing(const Rim& edges, const Vector3d& way) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < edges.points.size(); ++i) {
    const bool at_the_end = edges.points[i].x() > kHalfLength - 3e-3 &&
                            std::abs(edges.points[i].y()) < kHalfWidth - 5e-3 &&
                            edges.points[i].z() > height(edges.points[i].y()) - 3e-3;
    count += at_the_end && edges.outward[i].dot(way) > 0.9;
  }
  return count;
}

}  // namespace

TEST(Edges, LieWhereTwoFacesMeetAndEachOfThemEndsThere) {
  Bar bar;
  const Surface surface = surface_of(both(bar.upper_side(), bar.end_walls()));
  EXPECT_EQ(facing(surface.rim, Vector3d::UnitX()), 0U) << "the surface goes on around the corner";
  EXPECT_GE(facing(surface.edges, Vector3d::UnitX()), 20U) << "a place each 2 mm at least";
  EXPECT_GE(facing(surface.edges, Vector3d::UnitZ()), 20U);
  EXPECT_EQ(facing(surface.edges, -Vector3d::UnitX()), 0U);
}

TEST(Edges, AreNotThereWhereASurfaceIsRound) {
  Points points;
  for (double angle = 0; angle < M_PI; angle += 0.05) {
    for (double x = 0; x < 0.06; x += 1e-3)
      points.emplace_back(x, 0.02 * std::cos(angle), 0.02 * std::sin(angle));
  }
  const Surface surface = surface_of(points);
  EXPECT_EQ(surface.edges.points.size(), surface.rim.points.size());
}

TEST(Edges, HoldAPartAlongItselfWhereOnlyTheReferenceShowsItsEndWalls) {
  Bar bar;
  const Surface reference = surface_of(both(bar.upper_side(), bar.end_walls()));
  const Eigen::Isometry3d moved = Eigen::Translation3d(0.4, -0.1, 0.05) *
                                  Eigen::AngleAxisd(0.7, Vector3d(0.3, 0.2, 1).normalized());
  Points scanned = bar.upper_side();
  for (Vector3d& point : scanned)
    point = moved * point;
  ToolPath path;
  path.segments.emplace_back();
  for (int i = 0; i < 33; ++i) {
    Waypoint waypoint;
    waypoint.pose = Eigen::Translation3d(-0.08 + 0.005 * i, 0, height(0));
    path.segments.front().waypoints.push_back(waypoint);
  }
  const StretchResult result = stretch(reference, surface_of(scanned), path, {});
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  for (std::size_t i = 0; i < result.quality.size(); ++i) {
    const Vector3d truth = moved * path.segments[0].waypoints[i].pose.translation();
    EXPECT_LE((result.path.segments[0].waypoints[i].pose.translation() - truth).norm(), 1e-3)
        << "half of a cell of the grid";
    EXPECT_LE(result.quality[i].expected_error_tangential, 1e-3);
  }
}
