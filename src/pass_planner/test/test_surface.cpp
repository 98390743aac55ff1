// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pass_planner/surface.h"
#include "scan_cell_common/errors/errors.h"
#include "wall_and_roof.h"

namespace pass_planner {
namespace {

using Eigen::Vector3d;

class SurfaceOf : public testing::TestWithParam<SurfaceShape (*)(const std::vector<Rectangle>&)> {
 protected:
  const Surface surface{GetParam()(wall_and_roof())};
};

TEST_P(SurfaceOf, FindsTheNearestPlaceAndItsNormal) {
  const Surface::Place place = surface.nearest({-0.2, 0.1, 0.007});
  EXPECT_NEAR((place.point - Vector3d(-0.2, 0.1, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR(std::abs(place.normal.z()), 1, 1e-9);
  EXPECT_NEAR(place.distance, 0.007, 1e-6);
}

TEST_P(SurfaceOf, TellsWhereAWayIsBlocked) {
  const auto obstacle = surface.obstacle({0.06, 0, 0}, {-0.19, 0, 0.5});
  ASSERT_TRUE(obstacle);
  EXPECT_NEAR((*obstacle - Vector3d(0.05, 0, 0.02)).norm(), 0, 1e-6);
}

TEST_P(SurfaceOf, IsNotBlockedByThePlaceItself) {
  EXPECT_FALSE(surface.obstacle({0.04, 0, 0}, {-0.21, 0, 0.5}));
  EXPECT_FALSE(surface.obstacle({-0.2, 0, 0}, {-0.2, 0, 0.5}));
  EXPECT_FALSE(surface.obstacle({-0.2, 0, 0}, {-0.35, 0, 0.03}));
}

INSTANTIATE_TEST_SUITE_P(AMeshAndACloud, SurfaceOf, testing::Values(mesh_of, cloud_of));

TEST(Surface, IsRefusedWithoutAnything) {
  EXPECT_THROW(Surface{SurfaceShape()}, scan_cell_common::UnusableInput);
}

TEST(Surface, GoesWhereASimilarityPutsIt) {
  const tool_path_stretcher::Similarity similarity = {
      2, Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitX()).toRotationMatrix(), {1, 2, 3}};
  for (const auto& shape : {mesh_of(wall_and_roof()), cloud_of(wall_and_roof())}) {
    const Surface surface(placed(shape, similarity));
    const Surface::Place place = surface.nearest(similarity * Vector3d(-0.2, 0.1, 0.004));
    EXPECT_NEAR((place.point - similarity * Vector3d(-0.2, 0.1, 0)).norm(), 0, 1e-5);
    EXPECT_NEAR(std::abs(place.normal.y()), 1, 1e-9);
  }
}

}  // namespace
}  // namespace pass_planner
