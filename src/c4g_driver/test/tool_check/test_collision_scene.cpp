// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include "c4g_driver/collision_scene.h"
#include "scan_cell_common/errors/errors.h"
#include "tool_check/tool_check_test.h"

namespace c4g_driver {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;
using ShapeKind = CellShape::Kind;

CellShape shape(const std::string& name, const std::string& frame, ShapeKind kind,
                const Vector3d& size, const Isometry3d& pose = Isometry3d::Identity()) {
  return {name, frame, kind, size, pose};
}

/// The flange looks down at (0.8, 0, 0.6).
class CollisionTest : public ToolCheckTest {
 protected:
  CollisionTest() {
    joints_ = *step_to(smart5_six(), looking_down(0.8, 0, 0.6), degrees(0, 8, -124, 0, 48, 0));
  }

  std::vector<Collision> collisions() const {
    return CollisionScene(smart5_six(), shapes_).collisions(joints_, motion_.flange_to_tip);
  }

  /// Whether the ball on the flange, its centre at (0.8, 0, 0.5), meets the other shape.
  void expect_meets(const CellShape& other, double distance) {
    for (const double off : {-1e-4, 1e-4}) {
      shapes_.shapes = {other, shape("ball", "flange", ShapeKind::kSphere, {distance + off, 0, 0},
                                     Isometry3d(Translation3d(0, 0, 0.1)))};
      const auto found = collisions();
      ASSERT_EQ(found.size(), off > 0 ? 1u : 0u) << other.name;
      if (off < 0) continue;
      EXPECT_EQ(found[0].moving, "ball");
      EXPECT_EQ(found[0].standing, other.name);
      EXPECT_NEAR(found[0].depth, off, 1e-6);
    }
  }

  Joints joints_;
  CellShapes shapes_;
};

TEST_F(CollisionTest, MeetsWhatIsAsNearAsItsRadius) {
  expect_meets(shape("ball in the cell", "base_link", ShapeKind::kSphere, {0.1, 0, 0},
                     Isometry3d(Translation3d(0.8, 0.3, 0.1))),
               0.4);  // the centres are 0.5 apart
  expect_meets(shape("box", "base_link", ShapeKind::kBox, {0.2, 0.4, 0.2},
                     Isometry3d(Translation3d(0.8 - 0.3, 0.1, 0.5 - 0.3))),
               std::hypot(0.2, 0.2));  // its nearest edge is 0.2 away in x and in z
  expect_meets(shape("capsule", "base_link", ShapeKind::kCapsule, {0.05, 0.2, 0},
                     Isometry3d(Translation3d(0.8, 0.3, 0.5))),
               0.25);
  expect_meets(shape("floor", "base_link", ShapeKind::kHalfSpace, {0, 0, 1},
                     Isometry3d(Translation3d(9, 9, 0.2))),
               0.3);
  const double root = std::sqrt(0.5);
  expect_meets(shape("slope", "base_link", ShapeKind::kHalfSpace, {-root, 0, root},
                     Isometry3d(Translation3d(1.2, 5, 0.5))),
               0.4 * root);
}

TEST_F(CollisionTest, KnowsHowDeepBoxesAreInEachOther) {
  shapes_.shapes = {shape("bracket", "flange", ShapeKind::kBox, {0.6, 0.04, 0.04},
                          Isometry3d(Translation3d(0, 0, 0.03))),
                    shape("table", "base_link", ShapeKind::kBox, {1, 1, 0.5},
                          Isometry3d(Translation3d(0.8, 0, 0.3 + 0.012)))};
  // the bracket ends at 0.6 - 0.05, the table at 0.562
  auto found = collisions();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].depth, 0.012, 1e-6);
  shapes_.shapes[1].pose.translation().z() -= 0.013;
  EXPECT_TRUE(collisions().empty());
  shapes_.clearance = 0.0015;
  EXPECT_EQ(collisions().size(), 1u);
  shapes_.clearance = 0;
  shapes_.shapes[1].pose.translation().z() += 0.013;
  shapes_.may_touch = {{"bracket", "table"}};
  EXPECT_TRUE(collisions().empty());
}

TEST_F(CollisionTest, MovesWithTheTipAndTheLinks) {
  // a ball at the tool's tip just above a floor
  const Vector3d tip = (looking_down(0.8, 0, 0.6) * motion_.flange_to_tip).translation();
  shapes_.shapes = {shape("ball", "tool_tip", ShapeKind::kSphere, {0.01, 0, 0}),
                    shape("floor", "base_link", ShapeKind::kHalfSpace, {0, 0, 1},
                          Isometry3d(Translation3d(0, 0, tip.z() - 0.0101)))};
  EXPECT_TRUE(collisions().empty());
  shapes_.clearance = 2e-4;
  EXPECT_EQ(collisions().size(), 1u);
  shapes_.clearance = 0;
  shapes_.shapes[1].pose.translation().z() += 2e-4;
  EXPECT_EQ(collisions().size(), 1u);
}

TEST_F(CollisionTest, TakesALinkForACapsuleFromItsJointToTheNext) {
  // the upper arm, from the shoulder (0.15, 0, 0.45) to the elbow 0.59 m on at J2 = 90 degrees
  joints_ = degrees(0, 90, -90, 0, 10, 0);
  shapes_.links = {{"link_2", 0.1}};
  for (const double off : {-1e-3, 1e-3}) {
    const CellShape ball = shape("ball", "base_link", ShapeKind::kSphere, {0.2 + off, 0, 0});
    for (const Vector3d& place :
         {Vector3d(0.15 - 0.3, 0, 0.45), Vector3d(0.15 + 0.59 + 0.3, 0, 0.45),
          Vector3d(0.4, 0.3, 0.45), Vector3d(0.4, 0, 0.15)}) {
      shapes_.shapes = {ball};
      shapes_.shapes[0].pose.translation() = place;
      EXPECT_EQ(collisions().size(), off > 0 ? 1u : 0u) << place.transpose();
    }
  }
}

TEST_F(CollisionTest, MeetsTheSurfaceOfThePartButLetsTheToolTouchIt) {
  shapes_.shapes = {shape("ball", "flange", ShapeKind::kSphere, {0.1, 0, 0}),
                    shape("tool", "tool_tip", ShapeKind::kCapsule, {0.3, 0.5, 0})};
  CollisionScene scene(smart5_six(), shapes_);
  const auto count = [&] { return scene.collisions(joints_, motion_.flange_to_tip).size(); };
  for (const double off : {-1e-3, 1e-3}) {  // a square, 0.1 below the flange
    const double z = 0.5 + off;
    scene.set_part({{0.7, -0.1, z}, {0.9, -0.1, z}, {0.9, 0.1, z}, {0.7, 0.1, z}},
                   {{0, 1, 2}, {0, 2, 3}});
    EXPECT_EQ(count(), off > 0 ? 1u : 0u);
  }
  const auto found = scene.collisions(joints_, motion_.flange_to_tip);
  EXPECT_EQ(found[0].standing, "part");
  EXPECT_TRUE(std::isnan(found[0].depth));
  std::vector<Vector3d> points;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-0.1, 0.1);
  for (int i = 0; i < 20000; ++i)
    points.emplace_back(0.8 + share(random), share(random), 0.4951);
  scene.set_part(points, 0.002);  // cells from 0.494 to 0.496
  EXPECT_EQ(count(), 0u);
  for (Vector3d& point : points)
    point.z() = 0.5011;
  scene.set_part(points, 0.002);
  EXPECT_EQ(count(), 1u);
}

TEST_F(CollisionTest, RefusesFramesAndPartsThatAreNone) {
  shapes_.shapes = {shape("a", "camera", ShapeKind::kSphere, {1, 0, 0})};
  try {
    collisions();
    FAIL();
  } catch (const scan_cell_common::UnusableInput& unusable) {
    expect_within(unusable.what(), "frame of a: 'camera'; give base_link or one of link_1, ");
    expect_within(unusable.what(), "flange, tool_tip");
  }
  shapes_ = {};
  shapes_.links = {{"link_7", 0.1}};
  EXPECT_THROW(collisions(), scan_cell_common::UnusableInput);
  CollisionScene scene(smart5_six(), {});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Triangles = std::vector<std::array<std::size_t, 3>>;
  EXPECT_THROW(scene.set_part({}, 0.001), scan_cell_common::UnusableInput);
  EXPECT_THROW(scene.set_part({{0, 0, 0}}, 0.0), scan_cell_common::UnusableInput);
  EXPECT_THROW(scene.set_part({{nan, 0, 0}}, 0.001), scan_cell_common::UnusableInput);
  EXPECT_THROW(scene.set_part({{1e6, 0, 0}}, 0.001), scan_cell_common::UnusableInput);
  EXPECT_THROW(scene.set_part({{0, 0, 0}}, Triangles()), scan_cell_common::UnusableInput);
  EXPECT_THROW(scene.set_part({{0, 0, 0}}, Triangles{{0, 0, 1}}), scan_cell_common::UnusableInput);
  EXPECT_THROW(scene.set_part({{nan, 0, 0}}, Triangles{{0, 0, 0}}),
               scan_cell_common::UnusableInput);
}

TEST_F(CollisionTest, IsNamedWithItsWaypoint) {
  add_line({0.8, -0.2, 0.6}, {0.8, 0.2, 0.6}, 41);
  shapes_.shapes = {shape("ball", "flange", ShapeKind::kSphere, {0.05, 0, 0}),
                    shape("clamp", "base_link", ShapeKind::kBox, {0.1, 0.1, 0.1},
                          Isometry3d(Translation3d(0.8, 0.2, 0.6)))};
  const CollisionScene scene(smart5_six(), shapes_);
  const ToolCheck found = check_tool_motion(smart5_six(), narrowed(limits_, smart5_six()), from_,
                                            motion_, parameters_, &scene);
  // the clamp begins at y = 0.15, the ball meets it from y = 0.1 on: waypoint 30, and does so at 31
  ASSERT_GE(found.faults.size(), 10u);
  EXPECT_LE(found.faults.size(), 11u);
  EXPECT_EQ(found.faults.back().waypoint, 40u);
  EXPECT_EQ(found.faults.front().kind, ToolFault::Kind::kCollision);
  EXPECT_GE(found.faults.front().waypoint, 30u);
  expect_within(found.faults[1].what(), "ball and clamp: collide by 0.0");
}

}  // namespace
}  // namespace c4g_driver
