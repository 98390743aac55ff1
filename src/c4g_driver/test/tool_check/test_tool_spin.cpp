// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include "c4g_driver/collision_scene.h"
#include "tool_check/tool_check_test.h"

namespace c4g_driver {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

class ToolSpinTest : public ToolCheckTest {
 protected:
  ToolSpinTest() {
    motion_.flange_to_tip = Isometry3d(Translation3d(0.05, 0, 0.2));
    parameters_.free_about_z = true;
  }

  /// Adds a circle, looking down, with the tool's x along the way.
  void add_circle(double turns, int count) {
    for (int i = 0; i <= count; ++i) {
      const double angle = 2 * M_PI * turns * i / count;
      ToolWaypoint waypoint;
      waypoint.tip = looking_down(0.8 + 0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.4);
      waypoint.tip.linear() = waypoint.tip.linear() * AngleAxisd(-angle, Vector3d::UnitZ());
      motion_.waypoints.push_back(waypoint);
    }
  }

  /// Expects the same positions and axes of the tool.
  void expect_only_turned(const ToolCheck& found) const {
    ASSERT_EQ(found.tips.size(), motion_.waypoints.size());
    for (std::size_t i = 0; i < found.tips.size(); ++i) {
      const Isometry3d& tip = motion_.waypoints[i].tip;
      EXPECT_LT((found.tips[i].translation() - tip.translation()).norm(), 1e-12);
      EXPECT_LT((found.tips[i].linear().col(2) - tip.linear().col(2)).norm(), 1e-9);
      EXPECT_TRUE((flange_by_denavit_hartenberg(found.joints[i]) * motion_.flange_to_tip)
                      .isApprox(found.tips[i], 1e-7));
    }
  }

  static double way_of(const ToolCheck& found) {
    double way = 0;
    for (std::size_t i = 1; i < found.joints.size(); ++i) {
      const Joints change = found.joints[i] - found.joints[i - 1];
      way += change.cwiseQuotient(smart5_six().speed()).squaredNorm();
    }
    return way;
  }
};

TEST_F(ToolSpinTest, CuresAWristThatWouldTurnTooFar) {
  add_circle(2, 400);
  limits_.joint_lower[5] = -2.5;
  limits_.joint_upper[5] = 2.5;
  parameters_.free_about_z = false;
  const ToolCheck given = check();
  ASSERT_FALSE(given.possible());
  EXPECT_EQ(given.faults.front().kind, ToolFault::Kind::kJointRange);
  EXPECT_EQ(given.faults.front().joint, 5);
  parameters_.free_about_z = true;
  const ToolCheck found = check();
  EXPECT_TRUE(found.possible()) << found.refusal();
  expect_only_turned(found);
  EXPECT_LT(way_of(found), 0.5 * way_of(given));
}

TEST_F(ToolSpinTest, MovesTheJointsNoMoreThanAnyOneOrientationDoes) {
  add_circle(1, 200);
  const double found = way_of(check());
  const ToolMotion circle = motion_;
  parameters_.free_about_z = false;
  int possible = 0;
  for (int i = 0; i < 24; ++i) {
    for (std::size_t k = 0; k < motion_.waypoints.size(); ++k) {
      motion_.waypoints[k].tip.linear() =
          circle.waypoints.front().tip.linear() * AngleAxisd(M_PI / 12 * i, Vector3d::UnitZ());
    }
    const ToolCheck one = check();
    if (!one.possible()) continue;
    ++possible;
    EXPECT_LT(found, 1.01 * way_of(one)) << i;
  }
  EXPECT_GT(possible, 10);
}

TEST_F(ToolSpinTest, TurnsTheToolSoThatTheWristStandsStill) {
  // on a circle about axis 1, looking down with the tip on J6's axis: J1 has to move, and J6 only
  // if the orientation has to stay
  motion_.flange_to_tip = Isometry3d(Translation3d(0, 0, 0.2));
  for (int i = 0; i <= 200; ++i) {
    const double angle = 0.01 * i - 1;
    ToolWaypoint waypoint;
    waypoint.tip = looking_down(0.8 * std::cos(angle), 0.8 * std::sin(angle), 0.4);
    motion_.waypoints.push_back(waypoint);
  }
  const ToolCheck found = check();
  EXPECT_TRUE(found.possible()) << found.refusal();
  expect_only_turned(found);
  Joints least = found.joints.front(), most = least;
  for (const Joints& joints : found.joints) {
    least = least.cwiseMin(joints);
    most = most.cwiseMax(joints);
  }
  EXPECT_NEAR(most[0] - least[0], 2.0, 1e-6);  // J1 is determined by the way
  EXPECT_LT(most[5] - least[5], 0.02);
}

TEST_F(ToolSpinTest, StraightensTurnsThatGoToAndFroOnACurvedPart) {
  const auto add_arch = [&](double to_and_fro) {
    motion_.waypoints.clear();
    for (int i = 0; i <= 100; ++i) {
      const double tilt = 0.01 * i - 0.5;
      motion_.waypoints.emplace_back().tip =
          Translation3d(0.8, 0.2 * std::sin(tilt), 0.2 + 0.2 * std::cos(tilt)) *
          AngleAxisd(-tilt, Vector3d::UnitX()) * looking_down(0, 0, 0) *
          AngleAxisd(i % 2 == 0 ? to_and_fro : -to_and_fro, Vector3d::UnitZ());
    }
  };
  parameters_.free_about_z = false;
  add_arch(0);
  const ToolCheck smooth = check();
  ASSERT_TRUE(smooth.possible()) << smooth.refusal();
  add_arch(0.4);
  parameters_.free_about_z = true;
  const ToolCheck found = check();
  EXPECT_TRUE(found.possible()) << found.refusal();
  expect_only_turned(found);
  EXPECT_LT(way_of(found), 1.02 * way_of(smooth));
}

TEST_F(ToolSpinTest, BeginsAsTheRobotStands) {
  add_circle(0.5, 100);
  stand_at_begin(degrees(0, 8, -124, 0, 48, 0));
  const Joints begin = from_.joints;
  const ToolCheck found = check();
  EXPECT_TRUE(found.possible()) << found.refusal();
  EXPECT_TRUE(found.stands_there);
  EXPECT_LT((found.joints.front() - begin).norm(), 1e-6);
  EXPECT_TRUE(found.tips.front().isApprox(motion_.waypoints.front().tip, 1e-6));
  // with another turn of the tool, the path begins with that turn
  stand(*step_to(smart5_six(),
                 motion_.waypoints.front().tip * AngleAxisd(0.5, Vector3d::UnitZ()) *
                     motion_.flange_to_tip.inverse(),
                 begin));
  const ToolCheck turned = check();
  EXPECT_TRUE(turned.possible()) << turned.refusal();
  EXPECT_TRUE(turned.stands_there);
  EXPECT_LT((turned.joints.front() - from_.joints).norm(), 1e-6);
}

TEST_F(ToolSpinTest, TurnsTheBracketAwayFromAClamp) {
  motion_.flange_to_tip = Isometry3d(Translation3d(0, 0, 0.2));
  for (int i = 0; i <= 80; ++i)
    motion_.waypoints.emplace_back().tip = looking_down(0.8, 0.005 * i - 0.2, 0.4);
  // the bracket sticks out to x = 1.1 as given; a post stands there, in the middle of the path
  CellShapes shapes;
  shapes.shapes = {
      {"bracket", "flange", CellShape::Kind::kBox, {0.6, 0.04, 0.04}, Isometry3d::Identity()},
      {"post",
       "base_link",
       CellShape::Kind::kBox,
       {0.05, 0.05, 2},
       Isometry3d(Translation3d(1.05, 0, 0))}};
  const CollisionScene scene(smart5_six(), shapes);
  const auto check_among = [&] {
    return check_tool_motion(smart5_six(), narrowed(limits_, smart5_six()), from_, motion_,
                             parameters_, &scene);
  };
  parameters_.free_about_z = false;
  EXPECT_EQ(check_among().faults.front().kind, ToolFault::Kind::kCollision);
  parameters_.free_about_z = true;
  const ToolCheck found = check_among();
  EXPECT_TRUE(found.possible()) << found.refusal();
  expect_only_turned(found);
}

TEST_F(ToolSpinTest, TellsTheFaultsOfThePathAsGivenWhereNoTurnHelps) {
  add_circle(1, 100);
  limits_.workspace_max.x() = 0.6;
  const ToolCheck found = check();
  ASSERT_FALSE(found.possible());
  EXPECT_EQ(found.faults.front().kind, ToolFault::Kind::kWorkspace);
  EXPECT_TRUE(found.tips[50].isApprox(motion_.waypoints[50].tip, 1e-12));
}

TEST_F(ToolSpinTest, RefusesNoPathThatIsPossibleAsGiven) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> share(-1, 1);
  limits_.workspace_min.setConstant(-10);
  limits_.workspace_max.setConstant(10);
  const Joints middle = degrees(0, 10, -100, 0, 60, 0);
  const Joints wide = degrees(100, 30, 40, 100, 30, 120);
  int possible = 0;
  for (int path = 0; path < 20; ++path) {
    Joints begin, change;
    for (int k = 0; k < 6; ++k) {
      begin[k] = middle[k] + wide[k] * share(random);
      change[k] = 0.4 * share(random);
    }
    motion_.waypoints.clear();
    for (int i = 0; i <= 60; ++i)
      add_flange(flange_by_denavit_hartenberg(begin + change * i / 60.0), 0.01);
    parameters_.free_about_z = false;
    const ToolCheck given = check();
    parameters_.free_about_z = true;
    const ToolCheck found = check();
    if (!given.possible()) continue;
    ++possible;
    EXPECT_TRUE(found.possible()) << path << ": " << found.refusal();
    EXPECT_LT(way_of(found), 1.05 * way_of(given)) << path;
    expect_only_turned(found);
  }
  EXPECT_GT(possible, 12);
}

TEST_F(ToolSpinTest, GivesTheSameTurnsEachTime) {
  add_circle(1, 100);
  const ToolCheck found = check();
  const ToolCheck again = check();
  for (std::size_t i = 0; i < found.joints.size(); ++i)
    EXPECT_EQ(found.joints[i], again.joints[i]);
}

}  // namespace
}  // namespace c4g_driver
