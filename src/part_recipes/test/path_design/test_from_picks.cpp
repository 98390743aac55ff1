// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "path_design/designed_path.h"
#include "path_design/path_checks.h"
#include "path_design/shapes.h"
#include "path_design/spline.h"
#include "scan_cell_common/errors/errors.h"

using namespace part_recipes;
using namespace path_checks;
using Eigen::Vector3d;
using scan_cell_common::Refused;
using scan_cell_common::UnusableInput;
using shapes::kDegree;
using shapes::Points;

namespace {

Vector3d on_sphere(double radius, double turn, double rise) {
  return radius *
         Vector3d(std::cos(turn) * std::cos(rise), std::sin(turn) * std::cos(rise), std::sin(rise));
}

/// [m] from a place to the nearest waypoint
double reached(const tool_paths::ToolPath& path, const Vector3d& place) {
  double least = 1;
  for (const Vector3d& at : positions(path))
    least = std::min(least, (at - place).norm());
  return least;
}

}  // namespace

TEST(FromPicks, GoesThroughPicksOnASphereWithTheToolAlongItsRadius) {
  const double radius = 0.05;
  const int facets = 180;  // 1 degree
  const auto sphere = shapes::mesh_of(shapes::sphere(radius, facets));
  Points picks;
  for (int i = 0; i < 6; ++i)
    picks.push_back(on_sphere(radius * 1.01, 0.3 * i, 0.9 + 0.1 * (i % 2)));  // 0.5 mm off
  PickParameters parameters;
  parameters.path.max_step = 0.001;
  const auto path = path_from_picks(sphere, picks, parameters).path;
  const double facet = radius * (1 - std::cos(kDegree));
  for (const auto& waypoint : all(path)) {
    EXPECT_NEAR(position(waypoint).norm(), radius, facet);
    EXPECT_LT(angle(waypoint.pose.linear().col(2), -position(waypoint)), 0.1 * kDegree);
  }
  for (const Vector3d& pick : picks)
    EXPECT_LT(reached(path, radius * pick.normalized()), 0.0006);
  EXPECT_LT((position(all(path).front()) - radius * picks.front().normalized()).norm(), facet);
  EXPECT_LT((position(all(path).back()) - radius * picks.back().normalized()).norm(), facet);
}

TEST(FromPicks, ClosesTheLineWhereAsked) {
  PickParameters parameters;
  parameters.closed = true;
  parameters.path.max_step = 0.0005;
  const Points picks = {{0.02, 0, 0}, {0, 0.02, 0}, {-0.02, 0, 0}, {0, -0.02, 0}};
  const auto path =
      path_from_picks(shapes::mesh_of(shapes::plate(0.1, 0.1)), picks, parameters).path;
  ASSERT_EQ(path.segments.size(), 1U);
  const auto& waypoints = path.segments[0].waypoints;
  EXPECT_LT((position(waypoints.front()) - position(waypoints.back())).norm(), 1e-12);
  for (const Vector3d& pick : picks)
    EXPECT_LT(reached(path, pick), 0.006);
  // With even distances it is the uniform spline, so the middle of a side is at (10, 10) / 16 of 20
  // mm.
  EXPECT_LT(reached(path, {0.0125, 0.0125, 0}), 0.0003);
}

TEST(FromPicks, StandsOnTheEdgeBetweenTwoFacesWithTheNormalOfEach) {
  const auto box = shapes::mesh_of(shapes::box(0.1, 0.06, 0.03));
  PickParameters parameters;
  parameters.max_distance = 0.02;
  // After unfolding, the straight line crosses the edge in the middle of the picks' y.
  const auto path =
      path_from_picks(box, {{0.04, 0.01, 0.03}, {0.05, -0.01, 0.02}}, parameters).path;
  std::size_t on_edge = 0;
  for (const auto& waypoint : all(path)) {
    const Vector3d at = position(waypoint), z = waypoint.pose.linear().col(2);
    EXPECT_LT(std::min(angle(z, -Vector3d::UnitX()), angle(z, -Vector3d::UnitZ())), 1e-9);
    EXPECT_TRUE(std::abs(at.x() - 0.05) < 1e-9 || std::abs(at.z() - 0.03) < 1e-9);
    on_edge += (at - Vector3d(0.05, 0, 0.03)).norm() < 1e-4 ? 1 : 0;
  }
  EXPECT_EQ(on_edge, 2U);
}

TEST(FromPicks, NamesThePickThatIsTooFarFromTheSurface) {
  const auto plate = shapes::mesh_of(shapes::plate(0.1, 0.1, 0.02));
  const auto thing = [&plate](const Points& picks) {
    return thing_of<Refused>([&] { path_from_picks(plate, picks, {}); });
  };
  EXPECT_EQ(thing({{0.03, 0, 0}, {0.04, 0, 0.0021}, {0.04, 0.01, 0}}), "pick 2");
  EXPECT_EQ(thing({{0.03, 0, 0}, {0.04, 0, 0}, {0.06, 0.01, 0}}), "pick 3");
  EXPECT_EQ(thing({{-0.03, 0, 0}, {0.03, 0, 0}}), "line between picks 1 and 2");
  EXPECT_EQ(thing({{0.03, 0, 0}, {0.04, 0, 0.0019}}), "");
}

TEST(FromPicks, RefusesPicksThatMakeNoLine) {
  const auto plate = shapes::mesh_of(shapes::plate(0.1, 0.1));
  const auto thing = [&plate](const Points& picks) {
    return thing_of<UnusableInput>([&] { path_from_picks(plate, picks, {}); });
  };
  EXPECT_EQ(thing({}), "picks");
  EXPECT_EQ(thing({Vector3d::Zero()}), "picks");
  EXPECT_EQ(thing({Vector3d::Zero(), Vector3d::Zero()}), "pick 2");
  EXPECT_EQ(thing({Vector3d::Zero(), {0.01, NAN, 0}}), "pick 2");
}

TEST(CatmullRom, IsStraightOnALineAndPassesItsPoints) {
  const CatmullRom spline({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {3.5, 0, 0}}, false);
  ASSERT_EQ(spline.pieces(), 3U);
  EXPECT_LT((spline.at(0, 0) - Vector3d(0, 0, 0)).norm(), 1e-12);
  EXPECT_LT((spline.at(1, 0) - Vector3d(1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((spline.at(2, 1) - Vector3d(3.5, 0, 0)).norm(), 1e-12);
  double last = 0;
  for (std::size_t piece = 0; piece < 3; ++piece) {
    for (double share = 0.1; share <= 1; share += 0.1) {
      const Vector3d at = spline.at(piece, share);
      EXPECT_LT(at.tail<2>().norm(), 1e-12);
      EXPECT_GT(at.x(), last);  // never back
      last = at.x();
    }
  }
}

TEST(CatmullRom, IsUniformsCubicWherePointsAreEvenlyApart) {
  // With even distances the centripetal spline is the uniform one: in the middle of a piece
  // (-p0 + 9 p1 + 9 p2 - p3) / 16.
  const std::vector<Vector3d> p = {{0, 0, 0}, {0.6, 0.8, 0}, {1.2, 0, 0}, {1.8, -0.8, 0}};
  const CatmullRom spline({p[0], p[1], p[2], p[3]}, false);
  const Vector3d middle = (-p[0] + 9 * p[1] + 9 * p[2] - p[3]) / 16;
  EXPECT_LT((spline.at(1, 0.5) - middle).norm(), 1e-12);
}

TEST(CatmullRom, HasTheSlopeOfTheCentripetalSpline) {
  // The knots are spaced by the roots of the distances 1, 2 and 0.5; the slope in the second point
  // is Lagrange's through three knots (Yuksel et al. 2011).
  const CatmullRom spline({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {3.5, 0, 0}}, false);
  const double root = std::sqrt(2), slope = 1 - 3 / (1 + root) + 2 / root, small = 1e-7;
  EXPECT_NEAR((spline.at(1, small / root).x() - 1) / small, slope, 1e-5);
}
