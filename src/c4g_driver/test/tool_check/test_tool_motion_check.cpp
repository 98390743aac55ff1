// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include "scan_cell_common/errors/errors.h"
#include "tool_check/tool_check_test.h"

namespace c4g_driver {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using Jacobian = Eigen::Matrix<double, 6, 6>;

Jacobian numeric_jacobian(const Joints& joints) {
  constexpr double kStep = 1e-6;
  Jacobian jacobian;
  for (int k = 0; k < 6; ++k) {
    const Joints step = kStep * Joints::Unit(k);
    jacobian.col(k) = twist(flange_by_denavit_hartenberg(joints - step),
                            flange_by_denavit_hartenberg(joints + step)) /
                      (2 * kStep);
  }
  return jacobian;
}

TEST_F(ToolCheckTest, PassesAPathThatTheRobotCanFollow) {
  add_line({0.8, -0.2, 0.6}, {0.8, 0.2, 0.6}, 41);
  const ToolCheck found = check();
  EXPECT_TRUE(found.possible()) << found.refusal();
  EXPECT_FALSE(found.stands_there);
  ASSERT_EQ(found.joints.size(), 41u);
  for (std::size_t i = 0; i < 41; ++i) {
    EXPECT_TRUE((flange_by_denavit_hartenberg(found.joints[i]) * motion_.flange_to_tip)
                    .isApprox(motion_.waypoints[i].tip, 1e-7));
    EXPECT_TRUE(found.tips[i].isApprox(motion_.waypoints[i].tip, 1e-12));
  }
}

TEST_F(ToolCheckTest, RefusesNoPathMadeFromJointsWithinRangesAndFarFromSingularPostures) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  limits_.workspace_min.setConstant(-10);
  limits_.workspace_max.setConstant(10);
  int followed = 0;
  while (followed < 40) {
    Joints begin, change;
    for (int k = 0; k < 6; ++k) {
      const double reach = std::min(2.5, smart5_six().upper()[k] - smart5_six().lower()[k]) - 0.7;
      begin[k] = std::max(smart5_six().lower()[k], -2.5) + 0.35 + share(random) * reach;
      change[k] = 0.3 * (2 * share(random) - 1);
    }
    motion_.waypoints.clear();
    bool regular = true;
    for (int i = 0; i <= 50; ++i) {
      const Joints joints = begin + change * i / 50.0;
      const Eigen::JacobiSVD<Jacobian> svd(numeric_jacobian(joints));
      regular = regular && svd.singularValues()[5] > 0.03;
      add_flange(flange_by_denavit_hartenberg(joints), 1e-3);
    }
    if (!regular) continue;
    ++followed;
    stand(begin);
    const ToolCheck found = check();
    EXPECT_TRUE(found.possible()) << followed << ": " << found.refusal();
    EXPECT_TRUE(found.stands_there);
    for (std::size_t i = 0; i <= 50; ++i) {
      const Joints joints = begin + change * static_cast<double>(i) / 50;
      EXPECT_LT((found.joints[i] - joints).cwiseAbs().maxCoeff(), 1e-6);
    }
  }
}

TEST_F(ToolCheckTest, NamesTheWaypointAndTheJointThatLeavesItsRange) {
  // looking down, a turn of the flange about its own axis is one of J6 alone, in the other
  // direction
  add_flange(looking_down(0.8, 0, 0.6));
  stand_at_begin(from_.joints);
  const double begin = from_.joints[5];
  for (int i = 1; i <= 20; ++i)
    add_flange(looking_down(0.8, 0, 0.6) * AngleAxisd(-0.1 * i, Vector3d::UnitZ()));
  limits_.joint_lower[5] = begin - 1;
  limits_.joint_upper[5] = begin + 1.25;
  parameters_.joint_margin = 0.1;  // left of the range: 1.15
  const ToolCheck found = check();
  ASSERT_EQ(found.faults.size(), 9u);  // waypoints 12 .. 20
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(found.faults[i].kind, Kind::kJointRange);
    EXPECT_EQ(found.faults[i].waypoint, 12 + i);
    EXPECT_EQ(found.faults[i].joint, 5);
  }
  expect_within(found.refusal(), "waypoint 12, J6: ");
  expect_within(found.refusal(), "0.1 rad kept free");
  EXPECT_NEAR(found.margins[5].margin, 1.25 - 2.0, 1e-6);
  EXPECT_EQ(found.margins[5].waypoint, 20u);
  // J1 is at 0, except for the sagitta of the tip's lines, 0.02 m from J6's axis
  EXPECT_NEAR(found.margins[0].margin, 170 * M_PI / 180, 1e-4);
}

TEST_F(ToolCheckTest, BeginsFullTurnsAwayWhereTheRangeAsksForIt) {
  for (int i = 0; i <= 60; ++i)
    add_flange(looking_down(0.8, 0, 0.6) * AngleAxisd(-0.1 * i, Vector3d::UnitZ()));
  limits_.joint_upper[5] = 2;
  const ToolCheck found = check();
  EXPECT_TRUE(found.possible()) << found.refusal();
  EXPECT_NEAR(found.joints.back()[5] - found.joints.front()[5], 6.0, 1e-6);
  EXPECT_NEAR(found.joints.front()[5], from_.joints[5] - 2 * M_PI, 0.1);
  stand_at_begin(from_.joints);  // the robot stands there, but has no turn of J6 left
  const ToolCheck unwound = check();
  EXPECT_TRUE(unwound.possible()) << unwound.refusal();
  EXPECT_FALSE(unwound.stands_there);
  expect_within(unwound.as_it_stands, "J6: ");
  EXPECT_NEAR(unwound.joints.front()[5], from_.joints[5] - 2 * M_PI, 1e-6);
}

TEST_F(ToolCheckTest, SaysWhichWaypointsAreOutOfReach) {
  // the wrist's centre stands 0.095 above the flange, at most 0.59 + |(0.64707, 0.13)| from the
  // shoulder
  limits_.workspace_max.setConstant(3);
  add_line({0.8, 0, 0.6}, {1.6, 0, 0.6}, 81);
  std::size_t out = 0;
  while (std::hypot(0.8 + 0.01 * static_cast<double>(out) - 0.15, 0.6 + 0.095 - 0.45) <
         0.59 + std::hypot(0.64707, 0.13))
    ++out;
  const ToolCheck found = check();
  EXPECT_EQ(found.faults.front().waypoint, out);
  std::vector<std::size_t> unreached;
  for (const ToolFault& fault : found.faults) {
    if (fault.kind != Kind::kReach) continue;
    unreached.push_back(fault.waypoint);
    expect_within(fault.what(), "out of reach by ");
  }
  ASSERT_FALSE(unreached.empty());
  EXPECT_EQ(unreached.front(), out);
  EXPECT_EQ(unreached.size(), 81 - out);
  EXPECT_TRUE(found.joints[out - 1].allFinite());
  EXPECT_FALSE(found.joints[out].allFinite());
}

TEST_F(ToolCheckTest, NamesAStretchedArm) {
  limits_.workspace_max.setConstant(3);
  const double stretched = -std::atan2(0.13, 0.64707) * 180 / M_PI;  // J3: a straight forearm
  for (int i = 0; i <= 40; ++i)
    add_flange(flange_by_denavit_hartenberg(degrees(10, 20, stretched - 20.5 + i, 0, 60, 0)), 1e-3);
  const ToolCheck found = check();
  const ToolFault* singular = first_of(found, Kind::kSingular);
  ASSERT_NE(singular, nullptr);
  EXPECT_EQ(singular->waypoint, found.faults.front().waypoint);
  EXPECT_GE(singular->waypoint, 19u);  // J3 is 1.5 degrees before it; at 20 and 21 half a degree
  EXPECT_LE(singular->waypoint, 21u);
  expect_within(singular->what(), "the arm is stretched out");
}

TEST_F(ToolCheckTest, NamesAStraightWrist) {
  for (int i = 0; i <= 40; ++i)
    add_flange(flange_by_denavit_hartenberg(degrees(10, 8, -100, 20, -20.5 + i, 0)), 1e-3);
  stand(degrees(10, 8, -100, 20, -20.5, 0));
  const ToolCheck found = check();
  ASSERT_FALSE(found.possible());
  EXPECT_EQ(found.faults.front().kind, Kind::kSingular);
  EXPECT_GE(found.faults.front().waypoint, 20u);  // J5 is at half a degree before and after 0
  EXPECT_LE(found.faults.front().waypoint, 21u);
  expect_within(found.refusal(), "J4 and J6: the wrist is straight");
}

TEST_F(ToolCheckTest, NamesAWristThatTurnsOver) {
  // past the straight wrist at 2 degrees from it, as J4 turns by half a turn
  const Isometry3d straight = flange_by_denavit_hartenberg(degrees(0, 8, -100, 0, 0, 0));
  const double off = 2 * M_PI / 180;
  for (int i = 0; i <= 16; ++i) {
    const double tilt = (i - 8) * 5 * M_PI / 180;
    Isometry3d flange = straight;
    flange.linear() = straight.linear() * AngleAxisd(tilt, Vector3d::UnitY()) *
                      AngleAxisd(off, Vector3d::UnitX()).toRotationMatrix();
    add_flange(flange, 1e-3);
  }
  const ToolCheck found = check();
  ASSERT_FALSE(found.possible());
  const ToolFault* turns = first_of(found, Kind::kTurnsOver);
  ASSERT_NE(turns, nullptr);
  EXPECT_TRUE(turns->joint == 3 || turns->joint == 5);
  EXPECT_GE(turns->waypoint, 7u);
  EXPECT_LE(turns->waypoint, 9u);
}

TEST_F(ToolCheckTest, NamesAWristAboveAxisOne) {
  // J2 for which the wrist's centre stands above axis 1, by bisection in the closed form
  double low = -60 * M_PI / 180, high = -40 * M_PI / 180;
  const auto wrist = [](double j2) {
    Joints joints = degrees(0, 0, -90, 0, 60, 0);
    joints[1] = j2;
    const Isometry3d flange = flange_by_denavit_hartenberg(joints);
    return (flange * Vector3d(0, 0, -0.095)).x();
  };
  ASSERT_LT(wrist(low) * wrist(high), 0);
  for (int i = 0; i < 60; ++i)
    (wrist(low) * wrist((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  Joints above = degrees(0, 0, -90, 0, 60, 0);
  above[1] = low;
  const Isometry3d middle = flange_by_denavit_hartenberg(above);
  limits_.workspace_max.setConstant(3);
  for (int i = -10; i <= 10; ++i)
    add_flange(Eigen::Translation3d(0.01 * i, 0, 0) * middle, 1e-3);
  const ToolCheck found = check();
  const ToolFault* singular = first_of(found, Kind::kSingular);
  ASSERT_NE(singular, nullptr);
  EXPECT_GE(singular->waypoint, 8u);
  EXPECT_LE(singular->waypoint, 10u);
  expect_within(singular->what(), "the wrist stands above axis 1");
}

TEST_F(ToolCheckTest, NamesWhereTheFlangeLeavesItsBox) {
  add_line({0.8, -0.2, 0.6}, {0.8, 0.2, 0.6}, 41);
  limits_.workspace_max.y() = 0.105;
  const ToolCheck found = check();
  EXPECT_EQ(found.faults.size(), 10u);  // 0.11 .. 0.2
  EXPECT_EQ(found.faults.front().kind, Kind::kWorkspace);
  EXPECT_EQ(found.faults.front().waypoint, 31u);
  expect_within(found.refusal(), "waypoint 31, y of the flange: 0.11 m");
}

TEST_F(ToolCheckTest, BlamesNoWaypointForTheOneBeforeIt) {
  add_line({0.8, -0.2, 0.6}, {0.8, 0.2, 0.6}, 41);
  limits_.workspace_min.y() = -0.105;  // half-way from 9 to 10
  const ToolCheck found = check();
  ASSERT_EQ(found.faults.size(), 10u);
  EXPECT_EQ(found.faults.back().waypoint, 9u);
}

TEST_F(ToolCheckTest, SaysWhereOnlyAPostureReachesThatIsOutOfRange) {
  // turned round by J1, the shoulder is 0.3 m farther from what lies in front
  limits_.workspace_max.setConstant(3);
  add_line({0.5, 0.2, 0.9}, {1.1, 0.2, 0.9}, 31);
  const Isometry3d first = looking_down(0.5, 0.2, 0.9);
  for (const Joints& joints : postures_for(smart5_six(), first, Joints::Zero()).joints) {
    if (std::abs(joints[0]) > 2) stand(joints);
  }
  ASSERT_GT(std::abs(from_.joints[0]), 2);
  EXPECT_TRUE(check().possible());  // it may turn back before it begins
  (from_.joints[0] > 0 ? limits_.joint_lower : limits_.joint_upper)[0] =
      from_.joints[0] > 0 ? 2 : -2;
  const ToolCheck found = check();
  EXPECT_TRUE(found.stands_there);
  const ToolFault* lost = first_of(found, Kind::kPosture);
  ASSERT_NE(lost, nullptr);
  EXPECT_EQ(first_of(found, Kind::kReach), nullptr);
  std::size_t out = 0;
  while (std::hypot(std::hypot(0.5 + 0.02 * static_cast<double>(out), 0.2) + 0.15,
                    0.9 + 0.095 - 0.45) < 0.59 + std::hypot(0.64707, 0.13))
    ++out;
  EXPECT_EQ(lost->waypoint, out);
}

TEST_F(ToolCheckTest, NamesATurnThatHasTwoWaysRound) {
  add_line({0.8, -0.01, 0.6}, {0.8, 0.01, 0.6}, 3);
  motion_.waypoints[2].tip.linear() =
      motion_.waypoints[1].tip.linear() * AngleAxisd(M_PI, Vector3d::UnitZ());
  const ToolCheck found = check();
  ASSERT_FALSE(found.possible());
  EXPECT_EQ(found.faults.front().kind, Kind::kHalfTurn);
  EXPECT_EQ(found.faults.front().waypoint, 2u);
  expect_within(found.refusal(), "the direction of the turn is ambiguous");
}

TEST_F(ToolCheckTest, TakesThePostureInWhichThePathCanBeFollowed) {
  add_line({0.8, -0.1, 0.6}, {0.8, 0.1, 0.6}, 21);
  stand(degrees(0, 8, -124, 170, -48, -170));  // the wrist turned over
  EXPECT_LT(check().joints.front()[4], 0);
  limits_.joint_lower[4] = 0;
  limits_.joint_upper[4] = 2;
  const ToolCheck found = check();
  EXPECT_TRUE(found.possible()) << found.refusal();
  EXPECT_GT(found.joints.front()[4], 0);
}

TEST_F(ToolCheckTest, LeavesThePostureThatFailsOnTheWay) {
  for (int i = 0; i <= 20; ++i)  // the wrist bends more and more
    add_flange(looking_down(0.8, 0, 0.6) * AngleAxisd(-0.02 * i, Vector3d::UnitY()));
  stand(degrees(0, 8, -124, 170, -48, -170));  // the wrist turned over
  const double first = check().joints.front()[4];
  const double last = check().joints.back()[4];
  ASSERT_LT(first, 0);
  ASSERT_LT(last, first - 0.3);
  limits_.joint_lower[4] = (first + last) / 2;
  const ToolCheck found = check();
  EXPECT_TRUE(found.possible()) << found.refusal();
  EXPECT_NEAR(found.joints.front()[4], -first, 1e-6);
  limits_.joint_upper[4] = -(first + last) / 2 - 0.1;  // the other posture gets less far
  EXPECT_LT(check().joints.front()[4], 0);
}

}  // namespace
}  // namespace c4g_driver
