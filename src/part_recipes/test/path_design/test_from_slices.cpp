// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include "path_design/designed_path.h"
#include "path_design/path_checks.h"
#include "path_design/shapes.h"
#include "scan_cell_common/errors/errors.h"

using namespace part_recipes;
using namespace path_checks;
using Eigen::Vector3d;
using scan_cell_common::InvalidParameter;
using shapes::kDegree;

namespace {

SliceParameters along_x(double spacing) {
  SliceParameters parameters;
  parameters.spacing = spacing;
  parameters.direction = {1, 0, 0};
  parameters.order = RasterOrder::kOneWay;
  return parameters;
}

std::vector<double> row_places(const tool_paths::ToolPath& path) {
  std::set<long> places;  // [nm]
  for (const auto& segment : path.segments)
    for (const auto& waypoint : segment.waypoints)
      places.insert(std::lround(waypoint.pose.translation().y() * 1e9));
  std::vector<double> result;
  for (const long place : places)
    result.push_back(1e-9 * static_cast<double>(place));
  return result;
}

}  // namespace

TEST(FromSlices, PutsRowsExactlyASpacingApartAndCoversThePlate) {
  const auto made = path_from_slices(shapes::mesh_of(shapes::plate(0.2, 0.12)), along_x(0.005));
  const std::vector<double> rows = row_places(made.path);
  ASSERT_EQ(rows.size(), 24U);  // 120 mm in strips of 5 mm
  EXPECT_NEAR(rows.front(), -0.0575, 1e-9);
  for (std::size_t i = 1; i < rows.size(); ++i)
    EXPECT_NEAR(rows[i] - rows[i - 1], 0.005, 1.5e-9);
  for (const auto& segment : made.path.segments) {
    EXPECT_NEAR(position(segment.waypoints.front()).x(), -0.1, 1e-9);
    EXPECT_NEAR(position(segment.waypoints.back()).x(), 0.1, 1e-9);
  }
}

TEST(FromSlices, SplitsARowAtAHoleOnItsEdgeAndNotAtANarrowOne) {
  const auto plate = shapes::mesh_of(shapes::plate(0.2, 0.12, 0.015, {0.02, 0.01}));
  SliceParameters parameters = along_x(0.005);
  parameters.path.gap = 0.002;
  std::size_t crossing = 0;
  for (const auto& segment : path_from_slices(plate, parameters).path.segments) {
    for (const auto& waypoint : {segment.waypoints.front(), segment.waypoints.back()}) {
      const Vector3d at = position(waypoint);
      if (std::abs(std::abs(at.x()) - 0.1) < 1e-9) continue;
      // The hole is a polygon of 720 sides: at most 0.14 um inside of its circle.
      EXPECT_NEAR(std::hypot(at.x() - 0.02, at.y() - 0.01), 0.015, 2e-7);
      ++crossing;
    }
  }
  EXPECT_EQ(crossing, 12U);  // ends at the hole of the six rows within 15 mm of its middle
  parameters.path.gap = 0.031;
  const auto bridged = path_from_slices(plate, parameters).path;
  EXPECT_EQ(bridged.segments.size(), 24U);
}

TEST(FromSlices, KeepsTheMarginFromOutlineAndHole) {
  const auto plate = shapes::mesh_of(shapes::plate(0.2, 0.12, 0.015, {0.02, 0.01}));
  SliceParameters parameters = along_x(0.005);
  parameters.margin = 0.004;
  double least = 1;
  for (const Vector3d& at : positions(path_from_slices(plate, parameters).path)) {
    const double outline = std::min(0.1 - std::abs(at.x()), 0.06 - std::abs(at.y()));
    least = std::min({least, outline, std::hypot(at.x() - 0.02, at.y() - 0.01) - 0.015});
  }
  EXPECT_NEAR(least, 0.004, 2e-7);
}

TEST(FromSlices, LinksRowsInAZigzagOnTheSurfaceAndNeverOverTheHole) {
  const auto plate = shapes::mesh_of(shapes::plate(0.2, 0.12, 0.015, {0.02, 0.01}));
  SliceParameters parameters = along_x(0.005);
  parameters.order = RasterOrder::kZigzag;
  const auto path = path_from_slices(plate, parameters).path;
  EXPECT_LE(path.segments.size(), 4U);
  double length = 0;
  for (const auto& segment : path.segments) {
    for (std::size_t i = 1; i < segment.waypoints.size(); ++i) {
      const Vector3d from = position(segment.waypoints[i - 1]), to = position(segment.waypoints[i]);
      length += (to - from).norm();
      for (int k = 0; k <= 10; ++k) {
        const Vector3d at = from + 0.1 * k * (to - from);
        EXPECT_GT(std::hypot(at.x() - 0.02, at.y() - 0.01), 0.015 - 1.2e-4);  // chord error
      }
    }
  }
  // 24 rows of 200 mm less six chords of the hole, and the links
  double rows = 24 * 0.2;
  for (const double off : {-0.0125, -0.0075, -0.0025, 0.0025, 0.0075, 0.0125})
    rows -= 2 * std::sqrt(0.015 * 0.015 - off * off);
  EXPECT_GT(length, rows);
  EXPECT_LT(length, rows + 30 * 0.0075);
}

TEST(FromSlices, RunsAsManyPassesAlongTheBorderAsAsked) {
  SliceParameters parameters = along_x(0.005);
  parameters.margin = 0.003;
  parameters.border_passes = 2;
  const auto path = path_from_slices(shapes::mesh_of(shapes::plate(0.2, 0.12)), parameters).path;
  ASSERT_EQ(path.segments.front().name, "border 1.1");
  ASSERT_EQ(path.segments[1].name, "border 2.1");
  for (int pass = 0; pass < 2; ++pass) {
    for (const auto& waypoint : path.segments[static_cast<std::size_t>(pass)].waypoints) {
      const Vector3d at = position(waypoint);
      EXPECT_NEAR(std::min(0.1 - std::abs(at.x()), 0.06 - std::abs(at.y())), 0.003 + 0.005 * pass,
                  1e-8);
    }
  }
}

TEST(FromSlices, HoldsTheChordErrorAndTheRadiusOnACylinder) {
  const double radius = 0.05;
  const auto mesh = shapes::mesh_of(shapes::cylinder(radius, 0.2, 60 * kDegree, 240));
  for (const double chord : {0.0003, 0.0002, 0.00007}) {
    SliceParameters parameters = along_x(0.01);
    parameters.path.chord = chord;
    parameters.path.max_step = 1;
    const double facet = radius * (1 - std::cos(0.25 * kDegree));  // a facet off the cylinder
    const auto path = path_from_slices(mesh, parameters).path;
    for (const auto& segment : path.segments) {
      EXPECT_LT(segment.waypoints.size(), 60U);
      for (std::size_t i = 1; i < segment.waypoints.size(); ++i) {
        for (int k = 0; k <= 10; ++k) {
          const Vector3d at = position(segment.waypoints[i - 1]) * (1 - 0.1 * k) +
                              position(segment.waypoints[i]) * 0.1 * k;
          const double off = radius - std::hypot(at.x(), at.z());
          EXPECT_LE(off, chord + facet);
          EXPECT_GE(off, -1e-9);
        }
      }
    }
    for (const auto& waypoint : all(path)) {
      const Vector3d at = position(waypoint);
      const Vector3d out = Vector3d(at.x(), 0, at.z()).normalized();
      EXPECT_LT(angle(waypoint.pose.linear().col(2), -out), 0.1 * kDegree);
      EXPECT_LT(std::abs(waypoint.pose.linear().col(0).y()), 1e-9);  // along the travel
      EXPECT_GT(waypoint.pose.linear().col(0).x(), 0);
    }
  }
}

TEST(FromSlices, MeasuresTheMarginAlongTheSurface) {
  const double radius = 0.05, turned = 60 * kDegree;
  SliceParameters parameters = along_x(0.01);
  parameters.margin = 0.02;
  const auto mesh = shapes::mesh_of(shapes::cylinder(radius, 0.2, turned, 240));
  for (const auto& segment : path_from_slices(mesh, parameters).path.segments) {
    for (const auto& waypoint : {segment.waypoints.front(), segment.waypoints.back()}) {
      const Vector3d at = position(waypoint);
      EXPECT_NEAR(radius * (turned - std::abs(std::atan2(at.x(), at.z()))), 0.02, 5e-6);
    }
  }
}

TEST(FromSlices, FollowsANoisyCloudOfACylinder) {
  const double radius = 0.05;
  const auto soup = shapes::cylinder(radius, 0.1, 50 * kDegree, 200);
  const auto sheet = shapes::sheet_of(shapes::cloud_of(soup, 0.0006, 0.00003));
  const auto path = path_from_slices(sheet, along_x(0.005)).path;
  EXPECT_EQ(path.segments.size(), 20U);
  for (const auto& waypoint : all(path)) {
    const Vector3d at = position(waypoint);
    const Vector3d out = Vector3d(at.x(), 0, at.z()).normalized();
    EXPECT_NEAR(std::hypot(at.x(), at.z()), radius, 0.00005);
    EXPECT_LT(angle(waypoint.pose.linear().col(2), -out), 1 * kDegree);
  }
}

TEST(FromSlices, SplitsACloudAtItsHole) {
  const auto soup = shapes::plate(0.1, 0.06, 0.01);
  const auto path =
      path_from_slices(shapes::sheet_of(shapes::cloud_of(soup, 0.0005, 0.00002)), along_x(0.005))
          .path;
  EXPECT_EQ(path.segments.size(), 16U);  // twelve rows, four of them in two
  for (const Vector3d& at : positions(path))
    EXPECT_GT(std::hypot(at.x(), at.y()), 0.01 - 0.0005);
}

TEST(FromSlices, KeepsTheCornerOfARidgeWithTheNormalOfEachSide) {
  const auto path = path_from_slices(shapes::mesh_of(shapes::roof(0.1, 0.05)), along_x(0.01)).path;
  ASSERT_EQ(path.segments.size(), 5U);
  for (const auto& segment : path.segments) {
    std::size_t on_ridge = 0;
    for (const auto& waypoint : segment.waypoints) {
      const Vector3d at = position(waypoint), z = waypoint.pose.linear().col(2);
      EXPECT_NEAR(at.z(), -std::abs(at.x()), 1e-12);
      EXPECT_NEAR(std::abs(z.x()), std::sqrt(0.5), 1e-12);  // never the mean of both
      EXPECT_NEAR(z.z(), -std::sqrt(0.5), 1e-12);
      on_ridge += std::abs(at.x()) < 1e-12 ? 1 : 0;
    }
    EXPECT_EQ(on_ridge, 2U);
  }
}

TEST(FromSlices, TakesOnlyTheSideThatIsSeen) {
  const auto box = shapes::mesh_of(shapes::box(0.1, 0.06, 0.03));
  for (const Vector3d& at : positions(path_from_slices(box, along_x(0.01)).path))
    EXPECT_NEAR(at.z(), 0.03, 1e-12);
  SliceParameters side = along_x(0.01);
  side.path.from = {0, -1, 0};
  for (const auto& waypoint : all(path_from_slices(box, side).path)) {
    EXPECT_NEAR(position(waypoint).y(), -0.03, 1e-12);
    EXPECT_LT(angle(waypoint.pose.linear().col(2), Vector3d::UnitY()), 1e-9);
  }
}

TEST(FromSlices, LeavesOutWhatAnotherShellHides) {
  shapes::Soup two = shapes::plate(0.2, 0.12);
  Eigen::Isometry3d lifted(Eigen::Translation3d(0, 0, 0.02));
  two.add(shapes::moved(shapes::plate(0.05, 0.05), lifted));
  for (const Vector3d& at : positions(path_from_slices(shapes::mesh_of(two), along_x(0.01)).path)) {
    const bool below = std::abs(at.x()) < 0.025 - 1e-6 && std::abs(at.y()) < 0.025 - 1e-6;
    if (below) {
      EXPECT_NEAR(at.z(), 0.02, 1e-9);
    }
  }
}

TEST(FromSlices, GoesAlongTheLongestAxisWhereNoneIsGiven) {
  SliceParameters parameters;
  parameters.order = RasterOrder::kOneWay;
  const Eigen::Isometry3d turned(Eigen::AngleAxisd(0.3, Vector3d::UnitZ()));
  const auto path =
      path_from_slices(shapes::mesh_of(shapes::moved(shapes::plate(0.2, 0.12), turned)), parameters)
          .path;
  for (const auto& waypoint : all(path))
    EXPECT_LT(angle(waypoint.pose.linear().col(0), turned * Vector3d::UnitX()), 1e-9);
}

TEST(FromSlices, LiftsAndTurnsTheToolAsAsked) {
  SliceParameters parameters = along_x(0.01);
  parameters.path.stand_off = 0.007;
  parameters.path.waypoint_z = path_design::WaypointZ::kOutOfPart;
  parameters.path.tool_x = {0, 2, 0};
  parameters.path.speed = 0.05;
  const auto path = path_from_slices(shapes::mesh_of(shapes::plate(0.1, 0.05)), parameters).path;
  ASSERT_EQ(path.process_names, std::vector<std::string>{"speed"});
  for (const auto& waypoint : all(path)) {
    EXPECT_NEAR(position(waypoint).z(), 0.007, 1e-12);
    EXPECT_LT(angle(waypoint.pose.linear().col(2), Vector3d::UnitZ()), 1e-9);
    EXPECT_LT(angle(waypoint.pose.linear().col(0), Vector3d::UnitY()), 1e-9);
    EXPECT_EQ(waypoint.process_values, std::vector<double>{0.05});
  }
}

TEST(FromSlices, RefusesBadParametersByName) {
  const auto plate = shapes::mesh_of(shapes::plate(0.2, 0.12));
  const auto refused = [&plate](const std::function<void(SliceParameters&)>& change) {
    SliceParameters parameters = along_x(0.01);
    change(parameters);
    return thing_of<InvalidParameter>([&] { path_from_slices(plate, parameters); });
  };
  EXPECT_EQ(refused([](auto& p) { p.spacing = 0; }), "spacing");
  EXPECT_EQ(refused([](auto& p) { p.spacing = -0.01; }), "spacing");
  EXPECT_EQ(refused([](auto& p) { p.spacing = 0.13; }), "spacing");
  EXPECT_EQ(refused([](auto& p) { p.spacing = NAN; }), "spacing");
  EXPECT_EQ(refused([](auto& p) { p.direction = {0, 0, 0}; }), "direction");
  EXPECT_EQ(refused([](auto& p) { p.direction = {0, 0, 1}; }), "direction");
  EXPECT_EQ(refused([](auto& p) { p.path.from.setZero(); }), "from");
  EXPECT_EQ(refused([](auto& p) { p.path.tool_x = {0, 0, 0}; }), "tool_x");
  EXPECT_EQ(refused([](auto& p) { p.margin = 0.07; }), "margin");
  EXPECT_EQ(refused([](auto& p) { p.path.chord = 0; }), "chord");
}
