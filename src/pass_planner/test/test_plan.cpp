// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pass_planner/part.h"
#include "pass_planner/plan.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "tool_path_stretcher/reported_verdict.h"
#include "wall_and_roof.h"

namespace pass_planner {
namespace {

using Eigen::Vector3d;

class Planning : public testing::Test {
 protected:
  Planning() {
    robot.urdf = scan_cell_common::read_file(URDF_FILE);
    robot.base_link_in_world.translation() = Vector3d(-0.8, 0, 0);
  }

  PassPlan plan(const std::vector<Vector3d>& waypoints) const {
    return plan_passes(scanner, surface, places_on(waypoints), sight, Reach(robot), parameters);
  }

  std::vector<Surface::Place> places_on(const std::vector<Vector3d>& waypoints) const {
    std::vector<Surface::Place> places;
    for (const Vector3d& waypoint : waypoints)
      places.push_back(surface.nearest(waypoint));
    return places;
  }

  /// Both faces of the wall, and places on the plate at its foot and under the roof.
  static std::vector<Vector3d> all_around() {
    std::vector<Vector3d> waypoints;
    for (const double y : {-0.06, 0.0, 0.06}) {
      for (const double x : {0.0, 0.045, 0.06, 0.1})
        waypoints.emplace_back(x, y, 0);
      waypoints.emplace_back(0.05, y, 0.03);
    }
    return waypoints;
  }

  const scan_cell_common::ScannerModel scanner = ideal_scanner();
  const Surface surface{mesh_of(wall_and_roof())};
  SightParameters sight;
  RobotInCell robot;
  PlanParameters parameters;
};

TEST_F(Planning, FindsPassesThatSeeEveryWaypointAtAGoodAngle) {
  const PassPlan found = plan(all_around());
  EXPECT_TRUE(found.left.empty()) << found.why.front();
  ASSERT_FALSE(found.passes.empty());
  SightParameters good;
  good.max_light_angle = good.max_sight_angle = parameters.good_angle;
  const SightCheck check(scanner, surface, good);
  const PathSight seen = look_along(check, sweeps_of(found.passes), places_on(all_around()));
  EXPECT_EQ(seen.not_seen(), std::vector<std::size_t>());
  EXPECT_EQ(Reach(robot).refusal(found.passes), "");
  EXPECT_NO_THROW(scan_cell::check({"", found.passes}, scan_cell::ScanLimits()));
}

TEST_F(Planning, FindsTheSamePassesAgain) {
  const PassPlan one = plan(all_around()), other = plan(all_around());
  ASSERT_EQ(one.passes.size(), other.passes.size());
  for (std::size_t i = 0; i < one.passes.size(); ++i) {
    EXPECT_EQ(one.passes[i].name, other.passes[i].name);
    for (std::size_t k = 0; k < one.passes[i].poses.size(); ++k)
      EXPECT_EQ(one.passes[i].poses[k].matrix(), other.passes[i].poses[k].matrix());
  }
}

TEST_F(Planning, OfOneOpenPlaceIsOnePass) {
  const PassPlan found = plan({{-0.1, 0, 0}});
  ASSERT_EQ(found.passes.size(), 1U);
  EXPECT_NE(found.passes.front().lasers, scan_cell::PassLasers::kAlternate);
}

TEST_F(Planning, SaysThatTheRobotCannotGoThere) {
  robot.base_link_in_world.translation() = Vector3d(-3, 0, 0);
  const PassPlan found = plan({{-0.1, 0, 0}, {0.2, 0, 0}});
  EXPECT_TRUE(found.passes.empty());
  EXPECT_EQ(found.left, (std::vector<std::size_t>{0, 1}));
  ASSERT_EQ(found.why.size(), 2U);
  EXPECT_NE(found.why.front().find("passes that cannot be run"), std::string::npos);
  EXPECT_NE(found.why.front().find("target x"), std::string::npos) << found.why.front();
}

TEST_F(Planning, InTheRobotsBaseFrameFindsAPassForTheRobotWhereItStands) {
  robot.base_link_in_world.translation() = Vector3d(-1.2, 0, 0.5);
  robot.limits.workspace_min.z() = -0.5;  // [m] in base_link: where the floor is
  const Eigen::Isometry3d base_link = robot.base_link_in_world;
  tool_path_stretcher::Similarity to_base;
  to_base.translation = -base_link.translation();
  const Surface in_base(placed(mesh_of(wall_and_roof()), to_base));
  robot.frame = "base_link";
  PassPlan found = plan_passes(scanner, in_base, {in_base.nearest({1.1, 0, -0.5})}, sight,
                               Reach(robot), parameters);
  ASSERT_EQ(found.passes.size(), 1U) << found.why.front();
  for (Eigen::Isometry3d& pose : found.passes.front().poses)
    pose = base_link * pose;
  robot.frame = "world";
  EXPECT_EQ(Reach(robot).refusal(found.passes), "");
}

TEST_F(Planning, ProposesNoPassThatTheCellDoesNotAllow) {
  // An arc around the pillar sees its four faces best, but is 2.3 m long where 2 m are allowed.
  const Surface pillar(mesh_of({{{-0.4, -0.4, 0}, {0.8, 0, 0}, {0, 0.8, 0}},
                                {{-0.03, -0.03, 0}, {0.06, 0, 0}, {0, 0, 0.1}},
                                {{-0.03, 0.03, 0}, {0.06, 0, 0}, {0, 0, 0.1}},
                                {{-0.03, -0.03, 0}, {0, 0.06, 0}, {0, 0, 0.1}},
                                {{0.03, -0.03, 0}, {0, 0.06, 0}, {0, 0, 0.1}}}));
  std::vector<Surface::Place> places;
  for (const double z : {0.04, 0.06, 0.08}) {
    for (const auto& [x, y] : {std::pair{-0.03, 0.0}, {0.03, 0.0}, {0.0, -0.03}, {0.0, 0.03}})
      places.push_back(pillar.nearest({x, y, z}));
  }
  robot.base_link_in_world.translation() = Vector3d(-0.9, 0, 0);
  parameters.stand_off = 0.6;
  const PassPlan found = plan_passes(scanner, pillar, places, sight, Reach(robot), parameters);
  ASSERT_FALSE(found.passes.empty());
  EXPECT_NO_THROW(scan_cell::check({"", found.passes}, scan_cell::ScanLimits()));
}

TEST_F(Planning, RefusesAFrameThatTheCellDoesNotTell) {
  robot.frame = "table";
  EXPECT_THROW(plan({{-0.1, 0, 0}}), scan_cell_common::InvalidParameter);
}

TEST_F(Planning, KeepsClearOfAWallOnTheWayToTheFirstPass) {
  robot.start[0] = -1.0;  // [rad] beside the part, at y = 0.67 m or so
  ASSERT_GT(Reach(robot).start().translation().y(), 0.5);
  ASSERT_EQ(plan({{-0.1, 0, 0}}).passes.size(), 1U);
  auto rectangles = wall_and_roof();
  rectangles.push_back({{-2, 0.4, 0}, {4, 0, 0}, {0, 0, 2}});
  const Surface walled(mesh_of(rectangles));
  const PassPlan found =
      plan_passes(scanner, walled, {walled.nearest({-0.1, 0, 0})}, sight, Reach(robot), parameters);
  ASSERT_EQ(found.left.size(), 1U);
  EXPECT_NE(found.why.front().find("of the part or the floor"), std::string::npos)
      << found.why.front();
}

/// A pass from one side of the part to behind a wall beside it, and back.
scan_cell::ScanPass each_through_the_wall() {
  scan_cell::ScanPass pass;
  for (const double y : {0.0, 0.6})
    pass.poses.push_back(Eigen::Translation3d(0, y, 0) * above(-0.1));
  pass.speed = 0.1;
  pass.rate = 100;
  pass.lasers = scan_cell::PassLasers::kEach;
  return pass;
}

TEST_F(Planning, AfterEachLaserGoesOnFromThePassesStart) {
  auto rectangles = wall_and_roof();
  rectangles.push_back({{-2, 0.35, 0}, {4, 0, 0}, {0, 0, 2}});
  const Surface walled(mesh_of(rectangles));
  const auto plan_after = [&](const scan_cell::ScanPass& first) {
    return plan_passes(scanner, walled, {walled.nearest({-0.1, -0.1, 0})}, sight, Reach(robot),
                       parameters, {first});
  };
  scan_cell::ScanPass first = each_through_the_wall();
  EXPECT_TRUE(plan_after(first).left.empty());
  first.lasers = scan_cell::PassLasers::kLaser0;  // ends behind the wall
  EXPECT_FALSE(plan_after(first).left.empty());
}

TEST_F(Planning, AfterEachLaserTheRobotNeedNotGetPastItself) {
  robot.base_link_in_world = Eigen::Isometry3d::Identity();
  const auto at = [](double x, double y) { return Eigen::Translation3d(0, y, 0) * above(x); };
  scan_cell::ScanPass around = each_through_the_wall(), next = around;
  around.kind = scan_cell::PassKind::kPolyline;
  around.poses = {at(0.2, -0.8), at(0.9, 0), at(0.2, 0.8)};
  next.poses = {at(0.3, -0.8), at(0.4, -0.8)};
  EXPECT_EQ(Reach(robot).refusal({around, next}), "");
  around.lasers = scan_cell::PassLasers::kLaser0;
  EXPECT_NE(Reach(robot).refusal({around, next}), "");
}

TEST_F(Planning, SaysThatNoPassSeesAPlace) {
  sight.max_range = 0.1;
  const PassPlan found = plan({{-0.1, 0, 0}});
  ASSERT_EQ(found.left.size(), 1U);
  EXPECT_NE(found.why.front().find("no candidate sees it"), std::string::npos);
}

TEST_F(Planning, KeepsClearOfPartAndFloor) {
  parameters.clearance = 0.9;
  const PassPlan found = plan({{-0.1, 0, 0}});
  ASSERT_EQ(found.left.size(), 1U);
  EXPECT_NE(found.why.front().find("of the part or the floor"), std::string::npos)
      << found.why.front();
}

TEST_F(Planning, KeepsToTheMostPasses) {
  parameters.max_passes = 1;
  EXPECT_LE(plan(all_around()).passes.size(), 1U);
}

TEST_F(Planning, AlsoAtTheMostPassesTellsWhatNoPassSees) {
  parameters.max_passes = 1;
  auto places = places_on({{-0.1, 0, 0}});
  places.push_back({{-0.1, 0.02, -0.05}, Vector3d::UnitZ(), 0});  // below the plate
  const PassPlan found = plan_passes(scanner, surface, places, sight, Reach(robot), parameters);
  EXPECT_EQ(found.passes.size(), 1U);
  EXPECT_EQ(found.left, std::vector<std::size_t>{1});
  EXPECT_EQ(found.why, std::vector<std::string>{"no candidate sees it"});
}

TEST_F(Planning, TakesAnglesDownToTheLeast) {
  sight.max_light_angle = 0.15;
  EXPECT_NO_THROW(plan({{-0.1, 0, 0}}));
}

TEST_F(Planning, RefusesAPartInAnotherUnit) {
  const std::vector<Surface::Place> places = {{{0, 0, 0}, Vector3d::UnitZ(), 0},
                                              {{50, 0, 0}, Vector3d::UnitZ(), 0}};
  EXPECT_THROW(plan_passes(scanner, surface, places, sight, Reach(robot), parameters),
               scan_cell_common::UnusableInput);
}

TEST_F(Planning, NamesTheWaypointOffTheSurfaceAmongThoseOfThePath) {
  try {
    places_of({{0, 0, 0}, {-0.1, 0, 0}, {-0.1, 0, 0.05}}, surface, {1, 2});
    FAIL() << "50 mm off the surface is taken";
  } catch (const scan_cell_common::UnusableInput& error) {
    EXPECT_EQ(error.thing(), "waypoint 2");
  }
}

TEST(ReportedPart, IsRefusedInAnotherUnitThanTheReports) {
  const std::string folder = testing::TempDir();
  const PartFiles files = {folder + "unit.obj", folder + "unit.csv", folder + "unit.json", 1, "m"};
  scan_cell_common::save_text(files.reference, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  scan_cell_common::save_text(files.path, "x,y,z\n0.1,0.1,0\n0.2,0.1,0\n");
  const auto record = [](const std::string& file) {
    const auto of = tool_path_stretcher::record_of(file, "mm");
    return R"({"name": ")" + of.name + R"(", "sha256": ")" + of.sha256 + R"(", "units": "mm"})";
  };
  scan_cell_common::save_text(files.report,
                              R"({"verdict": "refused", "reason": "path_not_scanned", "message": "",
          "waypoints_concerned": [1], "candidates": [], "quality": [], "path": null,
          "transform": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
          "reference_points": null, "object_points": null,
          "files": {"object": null, "output": null, "reference": )" +
                                  record(files.reference) + R"(, "path": )" + record(files.path) +
                                  "}}");
  PartFiles in_mm = files;
  in_mm.reference_metres = 0.001;
  in_mm.path_units = "mm";
  EXPECT_EQ(load_part(in_mm).wanted, std::vector<std::size_t>{1});
  try {
    load_part(files);
    FAIL() << "a part of millimetres is taken for one of metres";
  } catch (const scan_cell_common::UnusableInput& error) {
    EXPECT_NE(error.cure().find("mm"), std::string::npos) << error.what();
  }
}

TEST_F(Planning, RefusesParametersThatMakeNoSense) {
  parameters.max_passes = 0;
  EXPECT_THROW(plan({{-0.1, 0, 0}}), scan_cell_common::InvalidParameter);
}

}  // namespace
}  // namespace pass_planner
