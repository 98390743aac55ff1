// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "edit/picking.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_cell_rviz {
namespace {

using cloud_preprocess::Cloud;
using cloud_preprocess::EditedCloud;
using Eigen::Vector3d;

/// Two layers of points 1 mm apart, at z 0 and z 0.1 m.
Cloud two_layers() {
  Cloud cloud;
  for (const float z : {0.0F, 0.1F})
    for (int x = -50; x <= 50; ++x)
      for (int y = -50; y <= 50; ++y)
        cloud.push_back({static_cast<float>(x) * 1e-3F, static_cast<float>(y) * 1e-3F, z});
  return cloud;
}

/// A ray from 1 m above, in a perspective view; 1 mm wide at the upper layer.
Ray down_at(double x, double y) {
  Ray ray;
  ray.origin = {0, 0, 1};
  ray.direction = (Vector3d(x, y, 0.1) - ray.origin).normalized();
  ray.widening = 1e-3;
  return ray;
}

TEST(Picking, MeansThePlaceNearestToTheMiddleOfTheRay) {
  const std::vector<Vector3d> places = {{0.0105, 0.02, 0.1}, {0.01, 0.02, 0.1}, {0.3, 0, 0.1}};
  EXPECT_EQ(meant(places, down_at(0.01, 0.02)), std::optional<std::size_t>(1));
  EXPECT_EQ(meant(places, down_at(0.0104, 0.02)), std::optional<std::size_t>(0));
  EXPECT_FALSE(meant(places, down_at(0.05, 0))) << "beside all of them";
  Ray up = down_at(0.01, 0.02);
  up.direction = -up.direction;
  EXPECT_FALSE(meant(places, up)) << "behind the viewer";
}

TEST(Picking, FindsThePointInFrontAndWhatIsGoneIsSeenThrough) {
  EditedCloud cloud(two_layers());
  const auto upper = picked(cloud.source(), cloud.kept(), down_at(0.01, 0.02));
  ASSERT_TRUE(upper);
  EXPECT_NEAR(upper->z(), 0.1, 1e-6);
  EXPECT_LT((*upper - Vector3d(0.01, 0.02, 0.1)).norm(), 1.5e-3);
  cloud_preprocess::HalfSpace above;
  above.point.z() = 0.05;
  cloud.add({false, above});
  const auto lower = picked(cloud.source(), cloud.kept(), down_at(0.01, 0.02));
  ASSERT_TRUE(lower);
  EXPECT_NEAR(lower->z(), 0, 1e-6);
  EXPECT_FALSE(picked(cloud.source(), cloud.kept(), down_at(0.2, 0))) << "beside the cloud";
}

TEST(Picking, FindsNothingBehindTheViewer) {
  const EditedCloud cloud(two_layers());
  Ray up = down_at(0, 0);
  up.direction = -up.direction;
  EXPECT_FALSE(picked(cloud.source(), cloud.kept(), up));
}

TEST(Picking, TakesWhatIsBehindAPolygonToItsDepth) {
  EditedCloud cloud(two_layers());
  const std::vector<Ray> corners = {down_at(-0.0105, -0.0205), down_at(0.0105, -0.0205),
                                    down_at(0.0105, 0.0205), down_at(-0.0105, 0.0205)};
  const Vector3d place(0, 0, 0.1);
  EXPECT_EQ(cloud.would_take({false, prism_behind(corners, place, 0.02)}).size(), 21u * 41u);
  EXPECT_EQ(cloud.would_take({false, prism_behind(corners, place, 0.2)}).size(), 2 * 21u * 41u);
}

TEST(Picking, RefusesAPolygonBesideTheView) {
  Ray aside = down_at(0, 0);
  aside.direction = Vector3d(1, 0, 0.4).normalized();  // above the horizon of the others
  const std::vector<Ray> corners = {down_at(0, 0), down_at(0.1, 0), down_at(0, 0.1), aside};
  EXPECT_THROW(prism_behind(corners, {0, 0, 0.1}, 0.1), scan_cell_common::UnusableInput);
}

TEST(Picking, TakesTheSideOfAPlaneOnWhichTheViewerIs) {
  EditedCloud cloud(two_layers());
  std::vector<Vector3d> places = {{0, 0, 0.05}, {0.01, 0, 0.05}, {0, 0.01, 0.05}};
  for (int turn = 0; turn < 2; ++turn) {
    const auto side = side_towards(places, {0, 0, 1});
    EXPECT_EQ(cloud.would_take({false, side}).size(), 101u * 101u);
    EXPECT_NEAR(side.normal.z(), 1, 1e-12);
    std::swap(places[0], places[1]);  // independent of the order of the clicks
  }
  places[2] = {0.02, 0, 0.05};
  EXPECT_THROW(side_towards(places, {0, 0, 1}), scan_cell_common::UnusableInput);
}

}  // namespace
}  // namespace scan_cell_rviz
