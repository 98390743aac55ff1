// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_check/tool_check_test.h"

namespace c4g_driver {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

// Looking down, the wrist's centre is above the flange: on a line x = r, J1 = -atan(y / r) is
// fastest at y = 0, at v / r.
TEST_F(ToolCheckTest, TellsTheSpeedOfTheSlowestPlace) {
  add_line({0.5, -0.1, 0.5}, {0.5, 0.1, 0.5}, 41, 0.1);
  const ToolCheck found = check();
  EXPECT_TRUE(found.possible()) << found.refusal();
  ASSERT_TRUE(found.slowest);
  EXPECT_EQ(found.slowest->joint, 0);
  EXPECT_NEAR(found.slowest->speed, 0.5 * smart5_six().speed()[0], 1e-6);
  EXPECT_EQ(found.slowest->wanted, 0.1);
  EXPECT_EQ(found.slowest->waypoint, 20u);
}

TEST_F(ToolCheckTest, RefusesASpeedThatAJointCannotGo) {
  add_line({0.5, -0.1, 0.5}, {0.5, 0.1, 0.5}, 41, 1.24);
  limits_.max_linear_speed = 2;
  const ToolCheck found = check();
  ASSERT_FALSE(found.possible());
  for (const ToolFault& fault : found.faults) {
    EXPECT_EQ(fault.kind, Kind::kJointSpeed);
    EXPECT_EQ(fault.joint, 0);
    // 1.24 r / (r^2 + y^2) above J1's speed
    const double y = 0.005 * (static_cast<double>(fault.waypoint) - 1 + fault.way) - 0.1;
    EXPECT_GT(1.24 * 0.5 / (0.25 + y * y), smart5_six().speed()[0] - 1e-9) << fault.waypoint;
  }
  const double edge = std::sqrt(1.24 * 0.5 / smart5_six().speed()[0] - 0.25);
  EXPECT_EQ(found.faults.front().waypoint, static_cast<std::size_t>((0.1 - edge) / 0.005) + 1);
  EXPECT_EQ(found.faults.back().waypoint, static_cast<std::size_t>((0.1 + edge) / 0.005) + 1);
  expect_within(found.refusal(), "at 1.24 m/s of the tip; the limit is 2.44346 rad/s");
}

TEST_F(ToolCheckTest, TurnsTheToolInPlaceNoFasterThanItsJointGoes) {
  for (int i = 0; i < 5; ++i)
    add_flange(looking_down(0.8, 0, 0.6) * AngleAxisd(0.2 * i, Vector3d::UnitZ()));
  // the tip is off J6's axis, so it moves, too: its time is that of the turn
  parameters_.rotational_speed = 9.5;
  for (ToolWaypoint& waypoint : motion_.waypoints)
    waypoint.speed = 1.4;
  EXPECT_TRUE(check().possible()) << check().refusal();
  parameters_.rotational_speed = 10;
  const ToolCheck found = check();
  EXPECT_EQ(found.faults.size(), 4u);
  EXPECT_EQ(found.faults.front().kind, Kind::kJointSpeed);
  EXPECT_EQ(found.faults.front().joint, 5);
}

TEST_F(ToolCheckTest, KeepsToTheReducedSpeedNearPeople) {
  add_line({0.8, -0.1, 0.6}, {0.8, 0.1, 0.6}, 21, 0.3);
  EXPECT_TRUE(check().possible()) << check().refusal();
  limits_.operation = Operation::kManual;
  const ToolCheck found = check();
  EXPECT_EQ(found.faults.front().kind, Kind::kToolSpeed);
  EXPECT_EQ(found.faults.front().waypoint, 1u);
  expect_within(found.refusal(), "speed of the tip: 0.3 m/s; the limit is 0.25 m/s");
}

TEST_F(ToolCheckTest, KeepsTheFlangeToTheReducedSpeedWhereTheToolTurns) {
  // the tip creeps while the flange swings around it, 0.2 m and 0.02 m away, at 1 rad/s
  limits_.operation = Operation::kManual;
  const Eigen::Isometry3d tip = looking_down(0.8, 0, 0.6) * motion_.flange_to_tip;
  const double arm = motion_.flange_to_tip.translation().norm();
  for (int i = 0; i < 5; ++i) {
    ToolWaypoint waypoint;
    waypoint.tip =
        Eigen::Translation3d(1e-4 * i, 0, 0) *
        (Eigen::Translation3d(tip.translation()) * AngleAxisd(0.05 * i, Vector3d::UnitY())) *
        Eigen::Isometry3d(tip.linear());
    motion_.waypoints.push_back(waypoint);
  }
  parameters_.rotational_speed = 0.24 / arm;
  EXPECT_TRUE(check().possible()) << check().refusal();
  parameters_.rotational_speed = 0.26 / arm;
  const ToolCheck found = check();
  ASSERT_FALSE(found.possible());
  expect_within(found.refusal(), "speed of the flange");
}

}  // namespace
}  // namespace c4g_driver
