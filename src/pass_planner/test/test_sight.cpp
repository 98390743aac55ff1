// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "pass_planner/sight.h"
#include "scan_cell_common/errors/errors.h"
#include "wall_and_roof.h"

namespace pass_planner {
namespace {

using Eigen::Vector3d;
using scan_cell::PassKind;
using scan_cell::PassLasers;
using scan_cell::ScanPass;

ScanPass line(PassLasers lasers) {
  return {"", PassKind::kLine, {above(-0.2), above(0.2)}, 0.1, 100, lasers, {}};
}

class SightOver : public testing::TestWithParam<SurfaceShape (*)(const std::vector<Rectangle>&)> {
 protected:
  Sighting sight_of(const Vector3d& point, PassLasers lasers = PassLasers::kLaser0) const {
    const SightCheck check(scanner, surface, parameters);
    return look_along(check, sweeps_of({line(lasers)}), {surface.nearest(point)}).best.front();
  }

  scan_cell_common::ScannerModel scanner = ideal_scanner();
  const Surface surface{GetParam()(wall_and_roof())};
  SightParameters parameters;
};

void expect_obstacle(const Sighting& sighting, const Vector3d& at) {
  ASSERT_TRUE(sighting.obstacle);
  EXPECT_NEAR((*sighting.obstacle - at).norm(), 0, 1e-5);
}

TEST_P(SightOver, SeesAnOpenPlaceAtItsAngles) {
  const Sighting sighting = sight_of({-0.1, 0.05, 0});
  EXPECT_EQ(sighting.sight, Sight::kSeen);
  EXPECT_EQ(sighting.fault, Fault::kNone);
  // The place lies 50 mm beside the plane in which light and camera move.
  EXPECT_NEAR(sighting.sight_angle, std::atan(0.05 / 0.5), 1e-6);
  EXPECT_NEAR(sighting.light_angle, std::atan(std::hypot(0.25, 0.05) / 0.5), 1e-6);
}

TEST_P(SightOver, NamesTheWallThatShadowsTheLight) {
  const Sighting sighting = sight_of({0.06, 0, 0});
  EXPECT_EQ(sighting.sight, Sight::kShadowed);
  EXPECT_EQ(sighting.fault, Fault::kLight);
  expect_obstacle(sighting, {0.05, 0, 0.02});
}

TEST_P(SightOver, TheOtherLaserSeesBehindTheWall) {
  EXPECT_EQ(sight_of({0.065, 0, 0}).sight, Sight::kShadowed);
  EXPECT_EQ(sight_of({0.065, 0, 0}, PassLasers::kLaser1).sight, Sight::kSeen);
  EXPECT_EQ(sight_of({0.065, 0, 0}, PassLasers::kEach).sight, Sight::kSeen);
  EXPECT_EQ(sight_of({0.065, 0, 0}, PassLasers::kAlternate).sight, Sight::kSeen);
}

TEST_P(SightOver, NamesTheRoofThatHidesFromTheCamera) {
  const Sighting sighting = sight_of({0.1, 0, 0});
  EXPECT_EQ(sighting.sight, Sight::kShadowed);
  EXPECT_EQ(sighting.fault, Fault::kSight);
  expect_obstacle(sighting, {0.1, 0, 0.1});
}

TEST_P(SightOver, LightAndCameraOnTwoSidesOfTheSurfaceSeeNothing) {
  const Sighting sighting = sight_of({0.05, 0, 0.025});
  EXPECT_EQ(sighting.sight, Sight::kShadowed);
}

TEST_P(SightOver, TellsTheLightFromTheSightThatGrazes) {
  parameters.max_light_angle = std::atan(0.5) - 0.01;
  EXPECT_EQ(sight_of({-0.1, 0, 0}).sight, Sight::kGrazing);
  EXPECT_EQ(sight_of({-0.1, 0, 0}).fault, Fault::kLight);
  parameters.max_light_angle = std::atan(0.5) + 0.1;
  EXPECT_EQ(sight_of({-0.1, 0, 0}).sight, Sight::kSeen);
  parameters.max_sight_angle = 0.1;
  EXPECT_EQ(sight_of({-0.1, 0.08, 0}).sight, Sight::kGrazing);
  EXPECT_EQ(sight_of({-0.1, 0.08, 0}).fault, Fault::kSight);
}

TEST_P(SightOver, TellsWhyAPlaceIsOutOfRange) {
  EXPECT_EQ(sight_of({0.25, 0, 0}).fault, Fault::kNotPassed);
  EXPECT_EQ(sight_of({-0.1, 0.3, 0}).fault, Fault::kImage);
  parameters.max_range = 0.49;
  EXPECT_EQ(sight_of({-0.1, 0, 0}).fault, Fault::kDepth);
  EXPECT_EQ(sight_of({-0.1, 0, 0}).sight, Sight::kOutOfRange);
}

TEST_P(SightOver, KeepsToTheRegionOfTheImage) {
  EXPECT_EQ(sight_of({-0.1, 0.1, 0}).sight, Sight::kSeen);
  parameters.region_y = 400;
  parameters.region_height = 200;  // 50 mm to both sides at 0.5 m
  EXPECT_EQ(sight_of({-0.1, 0.1, 0}).fault, Fault::kImage);
  EXPECT_EQ(sight_of({-0.1, 0.04, 0}).sight, Sight::kSeen);
}

TEST_P(SightOver, KeepsToTheRegionOfAPass) {
  const auto sight_with = [this](const scan_cell::CameraRegion& region) {
    ScanPass pass = line(PassLasers::kLaser0);
    pass.camera.region = region;
    const SightCheck check(scanner, surface, parameters);
    return look_along(check, sweeps_of({pass}), {surface.nearest({-0.1, 0.1, 0})}).best.front();
  };
  EXPECT_EQ(sight_with({0, 400, 0, 200}).fault, Fault::kImage);
  EXPECT_THROW(sight_with({0, 900, 0, 200}), scan_cell_common::InvalidParameter);
  parameters.region_y = 400;  // as the camera is set where a pass says nothing
  parameters.region_height = 200;
  EXPECT_EQ(sight_with({}).sight, Sight::kSeen);
}

INSTANTIATE_TEST_SUITE_P(AMeshAndACloud, SightOver, testing::Values(mesh_of, cloud_of));

TEST(Sight, OnAnArcFollowsTheCircle) {
  const Surface surface(mesh_of(wall_and_roof()));
  const auto scanner = ideal_scanner();
  const SightCheck check(scanner, surface, {});
  // Half a circle of 0.1 m about (-0.2, 0). The camera turns with it, so the light lies under it.
  const auto at = [](double angle) {
    return Eigen::Translation3d(-0.2, 0, 0.5) * Eigen::AngleAxisd(angle, Vector3d::UnitZ()) *
           Eigen::Translation3d(0, 0.1, 0) * Eigen::AngleAxisd(M_PI, Vector3d::UnitX());
  };
  const ScanPass arc = {
      "", PassKind::kArc, {at(-1.5), at(0), at(1.5)}, 0.1, 100, PassLasers::kLaser0, {}};
  const auto sweeps = sweeps_of({arc});
  const auto sight_of = [&](double x, double y) {
    return check.along(sweeps.front(), {surface.nearest({x, y, 0})}).front().sight;
  };
  EXPECT_EQ(sight_of(-0.3, 0.02), Sight::kSeen);
  EXPECT_EQ(sight_of(-0.2, 0.1), Sight::kSeen);
  EXPECT_EQ(sight_of(-0.2, -0.1), Sight::kSeen);  // the line of light reaches over the middle
  EXPECT_EQ(sight_of(-0.2, 0.4), Sight::kOutOfRange);
}

TEST(Sight, RefusesARegionOutsideTheSensor) {
  const Surface surface(mesh_of(wall_and_roof()));
  const auto scanner = ideal_scanner();
  SightParameters parameters;
  parameters.region_x = 600;
  parameters.region_width = 600;
  EXPECT_THROW(SightCheck(scanner, surface, parameters), scan_cell_common::InvalidParameter);
}

TEST(Sight, RefusesALaserThatWasNotCalibrated) {
  const Surface surface(mesh_of(wall_and_roof()));
  auto scanner = ideal_scanner();
  scanner.lasers[1].reset();
  const SightCheck check(scanner, surface, {});
  EXPECT_THROW(
      look_along(check, sweeps_of({line(PassLasers::kEach)}), {surface.nearest({0, 0, 0})}),
      scan_cell_common::UnusableInput);
}

TEST(Sight, NamesThePassThatHasNoArc) {
  try {
    sweeps_of({line(PassLasers::kLaser0),
               {"bend",
                PassKind::kArc,
                {above(0), above(0.1), above(0.2)},
                0.1,
                100,
                PassLasers::kLaser0,
                {}}});
    FAIL() << "three poses in a line are taken for an arc";
  } catch (const scan_cell_common::Refused& error) {
    EXPECT_EQ(error.thing().rfind("pass 2 (bend): ", 0), 0U) << error.what();
  }
}

}  // namespace
}  // namespace pass_planner
