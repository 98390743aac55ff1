// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "path_design/designed_path.h"
#include "path_design/path_checks.h"
#include "path_design/shapes.h"
#include "scan_cell_common/errors/errors.h"

using namespace part_recipes;
using namespace path_checks;
using Eigen::Vector3d;
using scan_cell_common::InvalidParameter;
using scan_cell_common::Refused;
using scan_cell_common::UnusableInput;
using shapes::kDegree;

namespace {

EdgeParameters inwards(double offset) {
  EdgeParameters parameters;
  parameters.offset = offset;
  return parameters;
}

/// [m] from a rectangle's outline about a centre, outside of it
double outside_square(const Vector3d& at, double low, double high) {
  const double x = std::max({low - at.x(), at.x() - high, 0.0});
  const double y = std::max({low - at.y(), at.y() - high, 0.0});
  return std::hypot(x, y);
}

std::size_t near(const tool_paths::Segment& segment, const Vector3d& place, double reach) {
  std::size_t count = 0;
  for (const auto& waypoint : segment.waypoints)
    count += (position(waypoint) - place).norm() < reach ? 1 : 0;
  return count;
}

}  // namespace

TEST(FromEdge, KeepsTheOffsetFromOutlineAndHoleExactly) {
  const auto plate = shapes::mesh_of(shapes::plate(0.2, 0.12, 0.015, {0.02, 0.01}));
  const auto path = path_from_edge(plate, inwards(0.005)).path;
  ASSERT_EQ(path.segments.size(), 2U);
  const bool outer_first = path.segments[0].name == "edge 1";
  const auto& outline = path.segments[outer_first ? 0 : 1];
  const auto& hole = path.segments[outer_first ? 1 : 0];
  EXPECT_EQ(hole.name, "hole 1");
  for (const auto& waypoint : outline.waypoints) {
    const Vector3d at = position(waypoint);
    EXPECT_NEAR(std::min(0.1 - std::abs(at.x()), 0.06 - std::abs(at.y())), 0.005, 1e-8);
  }
  for (const auto& waypoint : hole.waypoints)
    EXPECT_NEAR((position(waypoint) - Vector3d(0.02, 0.01, 0)).norm(), 0.02, 2e-7);
}

TEST(FromEdge, ClosesItsLoopsAndGoesAroundWithTheSurfaceOnTheLeft) {
  const auto plate = shapes::mesh_of(shapes::plate(0.2, 0.12, 0.015, {0.02, 0.01}));
  for (const double offset : {0.0, 0.004}) {
    for (const auto& segment : path_from_edge(plate, inwards(offset)).path.segments) {
      EXPECT_LT((position(segment.waypoints.front()) - position(segment.waypoints.back())).norm(),
                1e-12);
      double area = 0;
      for (std::size_t i = 1; i < segment.waypoints.size(); ++i)
        area += position(segment.waypoints[i - 1]).cross(position(segment.waypoints[i])).z();
      EXPECT_EQ(area > 0, segment.name == "edge 1") << segment.name;
    }
  }
}

TEST(FromEdge, KeepsSharpCornersAndTurnsTheToolOnThem) {
  for (const double offset : {0.0, 0.005}) {
    const auto path =
        path_from_edge(shapes::mesh_of(shapes::plate(0.2, 0.12)), inwards(offset)).path;
    ASSERT_EQ(path.segments.size(), 1U);
    for (const double x : {-1, 1})
      for (const double y : {-1, 1})
        EXPECT_EQ(near(path.segments[0], {x * (0.1 - offset), y * (0.06 - offset), 0}, 1e-8), 2U);
    for (const auto& waypoint : path.segments[0].waypoints) {
      const Vector3d x = waypoint.pose.linear().col(0);
      EXPECT_NEAR(std::max(std::abs(x.x()), std::abs(x.y())), 1, 1e-6);  // along a side
    }
  }
}

TEST(FromEdge, GoesRoundTheCornersOfAHoleInArcs) {
  const auto plate = shapes::mesh_of(shapes::squares({"xxx", "x x", "xxx"}, 0.04));
  EdgeParameters parameters = inwards(0.01);
  parameters.loops = Loops::kHoles;
  const auto path = path_from_edge(plate, parameters).path;
  ASSERT_EQ(path.segments.size(), 1U);
  std::size_t on_arcs = 0;
  for (const auto& waypoint : path.segments[0].waypoints) {
    const Vector3d at = position(waypoint);
    EXPECT_NEAR(outside_square(at, 0.04, 0.08), 0.01, 1.1e-6);
    const bool aside = at.x() < 0.04 || at.x() > 0.08, above = at.y() < 0.04 || at.y() > 0.08;
    on_arcs += aside && above ? 1 : 0;
  }
  EXPECT_GE(on_arcs, 8U);  // a quarter of a circle of 10 mm in chords 0.1 mm off: 3 or more each
}

TEST(FromEdge, BecomesTwoLoopsWhereANeckIsTooNarrow) {
  const auto dumbbell =
      shapes::mesh_of(shapes::squares({"xxx   xxx", "xxxxxxxxx", "xxx   xxx"}, 0.02));
  EXPECT_EQ(path_from_edge(dumbbell, inwards(0.008)).path.segments.size(), 1U);
  const auto path = path_from_edge(dumbbell, inwards(0.012)).path;
  ASSERT_EQ(path.segments.size(), 2U);
  for (const Vector3d& at : positions(path)) {
    EXPECT_GE(std::min({at.x(), at.y(), 0.18 - at.x(), 0.06 - at.y()}), 0.012 - 1e-7);
    EXPECT_TRUE(at.x() < 0.06 || at.x() > 0.12);
  }
  EXPECT_EQ(thing_of<Refused>([&] { path_from_edge(dumbbell, inwards(0.031)); }), "offset");
}

TEST(FromEdge, MeasuresTheOffsetAlongTheSurface) {
  const double radius = 0.05, turned = 60 * kDegree;
  const auto mesh = shapes::mesh_of(shapes::cylinder(radius, 0.2, turned, 240));
  for (const auto& waypoint : all(path_from_edge(mesh, inwards(0.02)).path)) {
    const Vector3d at = position(waypoint);
    const double side = radius * (turned - std::abs(std::atan2(at.x(), at.z())));
    const double end = std::min(at.y(), 0.2 - at.y());
    EXPECT_NEAR(std::min(side, end), 0.02, 2e-6);
    const Vector3d out = Vector3d(at.x(), 0, at.z()).normalized();
    EXPECT_LT(angle(waypoint.pose.linear().col(2), -out), 0.1 * kDegree);
  }
}

TEST(FromEdge, GoesOutwardsStraightOn) {
  const auto path = path_from_edge(shapes::mesh_of(shapes::plate(0.2, 0.2)), inwards(-0.01)).path;
  ASSERT_EQ(path.segments.size(), 1U);
  for (const Vector3d& at : positions(path))
    EXPECT_NEAR(outside_square(at, -0.1, 0.1), 0.01, 1.1e-6);
}

TEST(FromEdge, FollowsOneFaceOfABoxWithItsOwnNormal) {
  const auto box = shapes::mesh_of(shapes::box(0.1, 0.06, 0.03));
  EdgeParameters parameters = inwards(0);
  parameters.near = {0.05, 0, 0.015};
  const auto path = path_from_edge(box, parameters).path;
  ASSERT_EQ(path.segments.size(), 1U);
  for (const auto& waypoint : path.segments[0].waypoints) {
    EXPECT_NEAR(position(waypoint).x(), 0.05, 1e-12);
    EXPECT_LT(angle(waypoint.pose.linear().col(2), -Vector3d::UnitX()), 1e-9);
  }
  for (const double y : {-0.03, 0.03})
    for (const double z : {0.0, 0.03})
      EXPECT_EQ(near(path.segments[0], {0.05, y, z}, 1e-9), 2U);
  parameters.near = {0.07, 0, 0.015};
  EXPECT_EQ(thing_of<Refused>([&] { path_from_edge(box, parameters); }), "near");
}

TEST(FromEdge, FollowsTheOutlineOfWhatIsSeenOfAClosedPart) {
  for (const auto& waypoint :
       all(path_from_edge(shapes::mesh_of(shapes::box(0.1, 0.06, 0.03)), inwards(0.002)).path)) {
    const Vector3d at = position(waypoint);
    EXPECT_NEAR(at.z(), 0.03, 1e-12);
    EXPECT_NEAR(std::min(0.05 - std::abs(at.x()), 0.03 - std::abs(at.y())), 0.002, 1e-8);
  }
}

TEST(FromEdge, RefusesAFaceWithoutAnEdge) {
  EdgeParameters parameters;
  parameters.near = {0, 0, 0.05};
  const auto sphere = shapes::mesh_of(shapes::sphere(0.05, 60));
  EXPECT_EQ(thing_of<Refused>([&] { path_from_edge(sphere, parameters); }), "edge");
}

TEST(FromEdge, SmoothsTheEdgeOfACloudAndKeepsItsCorners) {
  const auto sheet =
      shapes::sheet_of(shapes::cloud_of(shapes::plate(0.1, 0.06, 0.012), 0.0005, 0.00002));
  const auto path = path_from_edge(sheet, inwards(0)).path;
  ASSERT_EQ(path.segments.size(), 2U);
  for (const auto& segment : path.segments) {
    for (const auto& waypoint : segment.waypoints) {
      const Vector3d at = position(waypoint);
      const double off = segment.name == "hole 1"
                             ? std::hypot(at.x(), at.y()) - 0.012
                             : std::min(0.05 - std::abs(at.x()), 0.03 - std::abs(at.y()));
      EXPECT_NEAR(off, 0.0004, 0.0005) << segment.name;  // a cloud ends half a leaf before
      EXPECT_LT(angle(waypoint.pose.linear().col(2), -Vector3d::UnitZ()), 1 * kDegree);
    }
    std::size_t turns = 0;
    for (std::size_t i = 1; i < segment.waypoints.size(); ++i)
      turns +=
          segment.waypoints[i].pose.translation() == segment.waypoints[i - 1].pose.translation()
              ? 1
              : 0;
    // The loop begins at a corner: three are passed, and the fourth is both ends.
    EXPECT_EQ(turns, segment.name == "hole 1" ? 0U : 3U) << segment.name;
  }
}

TEST(FromEdge, TakesTheFaceOfACloudWithoutTheNormalsOfItsWalls) {
  const auto sheet =
      shapes::sheet_of(shapes::cloud_of(shapes::box(0.1, 0.06, 0.03), 0.0005, 0.00002));
  for (const auto& waypoint : all(path_from_edge(sheet, inwards(0)).path)) {
    EXPECT_NEAR(position(waypoint).z(), 0.03, 0.0003);
    EXPECT_LT(angle(waypoint.pose.linear().col(2), -Vector3d::UnitZ()), 3 * kDegree);
  }
}

TEST(FromEdge, FollowsBothOfTwoShells) {
  shapes::Soup two = shapes::plate(0.05, 0.05);
  const Eigen::Isometry3d aside(Eigen::Translation3d(0.1, 0, 0.01));
  two.add(shapes::moved(shapes::plate(0.03, 0.03), aside));
  const auto path = path_from_edge(shapes::mesh_of(two), inwards(0.001)).path;
  EXPECT_EQ(path.segments.size(), 2U);
}

TEST(FromEdge, StandsDegenerateTrianglesCracksAndMixedWinding) {
  shapes::Soup plate = shapes::squares({"xxx", "xxx", "xxx"}, 0.03);
  std::swap(plate.triangles[1][0], plate.triangles[1][1]);  // wound the wrong way round
  plate.triangles.push_back({0, 0, 1});
  plate.triangles.push_back({0, 1, 1});
  // A T on the diagonal of the middle square: a corner of two triangles on only one side of it.
  const auto middle = static_cast<std::uint32_t>(plate.vertices.size());
  plate.vertices.emplace_back(0.045, 0.045, 0);
  const auto [a, b, c] = plate.triangles[8];
  plate.triangles[8] = {a, b, middle};
  plate.triangles.push_back({b, c, middle});
  const auto path = path_from_edge(shapes::mesh_of(plate), inwards(0.01)).path;
  ASSERT_EQ(path.segments.size(), 1U);
  for (const auto& waypoint : path.segments[0].waypoints) {
    const Vector3d at = position(waypoint);
    EXPECT_NEAR(std::min({at.x(), at.y(), 0.09 - at.x(), 0.09 - at.y()}), 0.01, 1e-8);
    EXPECT_LT(angle(waypoint.pose.linear().col(2), -Vector3d::UnitZ()), 1e-9);
  }
}

TEST(FromEdge, FollowsARaggedHoleInOneClosedLine) {
  const auto panel = shapes::mesh_of(shapes::panel(300));  // stairs of 1 mm around the hole
  const auto path = path_from_edge(panel, inwards(0.005)).path;
  ASSERT_EQ(path.segments.size(), 2U);
  for (const auto& segment : path.segments) {
    EXPECT_LT((position(segment.waypoints.front()) - position(segment.waypoints.back())).norm(),
              1e-12);
    if (segment.name != "hole 1") continue;
    for (const auto& waypoint : segment.waypoints) {
      const Vector3d at = position(waypoint);
      EXPECT_NEAR(std::hypot(at.x() - 0.08, at.y() - 0.03), 0.025, 0.0015);
    }
  }
}

TEST(FromEdge, TurnsAShellOutwardsWhateverItsWinding) {
  for (const bool inside_out : {false, true}) {
    shapes::Soup box = shapes::box(0.1, 0.06, 0.03);
    for (shapes::Triangle& triangle : box.triangles)
      if (inside_out) std::swap(triangle[0], triangle[1]);
    for (const Vector3d& at : positions(path_from_edge(shapes::mesh_of(box), inwards(0)).path))
      EXPECT_NEAR(at.z(), 0.03, 1e-12);
  }
}

TEST(FromEdge, RefusesWhatIsNoSurface) {
  shapes::Soup soup = shapes::plate(0.1, 0.1);
  soup.vertices[2].x() = NAN;
  EXPECT_EQ(thing_of<UnusableInput>([&] { shapes::mesh_of(soup); }), "shape");
  soup.vertices = {Vector3d::Zero(), Vector3d::UnitX(), 2 * Vector3d::UnitX()};
  soup.triangles = {{0, 1, 2}};
  EXPECT_EQ(thing_of<UnusableInput>([&] { shapes::mesh_of(soup); }), "shape");
  EXPECT_EQ(thing_of<UnusableInput>([] { shapes::sheet_of({}); }), "cloud");
  const auto wall = shapes::cloud_of(shapes::plate(0.1, 0.1), 0.001, 0);
  EXPECT_EQ(thing_of<UnusableInput>([&] { shapes::sheet_of(wall, Vector3d::UnitX()); }), "cloud");
}
