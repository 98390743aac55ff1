// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures/made_preview.h"
#include "preview/joint_turn.h"

namespace scan_cell_rviz {
namespace {

constexpr double kTurn = 2 * M_PI;

/// The way to a path, a round of it, and the way back; J2 goes on, J1 comes back.
scan_cell_msgs::WorkPreview a_round() {
  scan_cell_msgs::WorkPreview preview;
  preview.joint_names = {"J1", "J2"};
  preview.path_waypoints = {-1, 0, 1, 2, 3, -1};
  preview.waypoints.resize(6);
  preview.joints = {9, 20, 0, 0.5, 2, 0.5 - kTurn / 3, 1, 0.5 - kTurn / 2, 0, 0.5 - kTurn, -9, -20};
  return preview;
}

TEST(JointTurn, IsOfTheJointThatTurnsMostAlongThePathItself) {
  const auto turn = most_turned(a_round());
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->joint, "J2");
  EXPECT_EQ(turn->place, 1u);
  EXPECT_DOUBLE_EQ(turn->from, 0.5);
  EXPECT_DOUBLE_EQ(turn->to, 0.5 - kTurn);
}

TEST(JointTurn, IsNoneWhereTheRobotDoesNotGetOrNothingTurns) {
  EXPECT_FALSE(most_turned({}));
  scan_cell_msgs::WorkPreview preview = a_round();
  for (double& angle : preview.joints)
    angle = std::nan("");
  EXPECT_FALSE(most_turned(preview));
  preview.joints.assign(12, 1);
  EXPECT_FALSE(most_turned(preview));
}

TEST(JointTurn, IsToldWithTheRangeThatTheRobotHasAndItsDriverNarrows) {
  const JointTurn turn{"J6", 1, -0.5, -0.5 + kTurn};
  EXPECT_EQ(text_of(turn, {}).toStdString(),
            "J6 turns most along the path: from -29 to 331 degrees.");
  RobotLimits limits;
  limits.of_robot = limits_in(
      R"(<robot name="arm"><link name="a"/><link name="b"/><link name="c"/>
           <joint name="J6" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
             <limit lower="-6.2831853" upper="3.1415927" velocity="1" effort="1"/></joint>
           <joint name="J7" type="continuous"><parent link="b"/><child link="c"/>
             <axis xyz="0 0 1"/></joint></robot>)");
  EXPECT_EQ(limits.of_robot.size(), 1u);
  const std::string turns = "J6 turns most along the path: from -29 to 331 degrees; its range is ";
  EXPECT_EQ(text_of(turn, limits).toStdString(), turns + "-360 to 180 degrees.");
  limits.lower = {-0.1, -M_PI};
  EXPECT_EQ(text_of(turn, limits).toStdString(), turns + "-180 to 180 degrees.");
  limits.upper = {0.1, 7};
  EXPECT_EQ(text_of(turn, limits).toStdString(), turns + "-180 to 180 degrees.") << "wider";
  limits.upper = {0.1, M_PI / 2};
  EXPECT_EQ(text_of(turn, limits).toStdString(), turns + "-180 to 90 degrees.");
  EXPECT_TRUE(limits_in("no URDF").empty());
}

}  // namespace
}  // namespace scan_cell_rviz
