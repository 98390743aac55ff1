// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/errors/errors.h"
#include "tool_check/tool_check_test.h"

namespace c4g_driver {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class ToolInputTest : public ToolCheckTest {
 protected:
  ToolInputTest() { add_line({0.8, -0.1, 0.6}, {0.8, 0.1, 0.6}, 21); }

  std::string complaint() const {
    try {
      check();
    } catch (const scan_cell_common::UnusableInput& unusable) {
      return unusable.what();
    }
    return "";
  }
};

TEST_F(ToolInputTest, RefusesLessThanTwoWaypoints) {
  motion_.waypoints.resize(1);
  expect_within(complaint(), "tool path: 1 waypoints; give two or more");
  motion_.waypoints.clear();
  expect_within(complaint(), "tool path: 0 waypoints");
}

TEST_F(ToolInputTest, RefusesWhatIsNoNumberOrNoRotation) {
  const ToolMotion good = motion_;
  motion_.waypoints[3].tip.translation().y() = kNan;
  expect_within(complaint(), "waypoint 3: a position that is not finite");
  motion_ = good;
  motion_.waypoints[4].tip.linear()(1, 1) = kNan;
  expect_within(complaint(), "waypoint 4, orientation: not a rotation");
  motion_ = good;
  motion_.waypoints[5].tip.linear() *= 1.001;
  expect_within(complaint(), "waypoint 5, orientation");
  motion_ = good;
  motion_.flange_to_tip.linear().col(0) *= -1;
  expect_within(complaint(), "flange_to_tip, orientation");
}

TEST_F(ToolInputTest, RefusesASpeedThatIsNone) {
  for (const double speed : {0.0, -0.1, kNan, std::numeric_limits<double>::infinity()}) {
    motion_.waypoints[7].speed = speed;
    expect_within(complaint(), "waypoint 7, speed");
  }
  motion_.waypoints[7].speed = 0.05;
  motion_.waypoints[7].zone = -1e-3;
  expect_within(complaint(), "waypoint 7, zone");
}

TEST_F(ToolInputTest, TakesWaypointsInOnePlace) {
  motion_.waypoints[8].tip = motion_.waypoints[9].tip = motion_.waypoints[10].tip;
  motion_.waypoints[1].tip = motion_.waypoints[0].tip;
  const ToolCheck found = check();
  EXPECT_TRUE(found.possible()) << found.refusal();
  motion_.waypoints.assign(5, motion_.waypoints.front());
  const ToolCheck nowhere = check();
  EXPECT_TRUE(nowhere.possible()) << nowhere.refusal();
  EXPECT_FALSE(nowhere.slowest);
}

TEST_F(ToolInputTest, RefusesAMarginThatLeavesNothing) {
  parameters_.joint_margin = 1;
  limits_.joint_lower[2] = -2.5;
  limits_.joint_upper[2] = -1;
  EXPECT_THROW(check(), scan_cell_common::InvalidParameter);
}

TEST_F(ToolInputTest, FollowsThousandsOfWaypointsTheSameEachTime) {
  motion_.waypoints.clear();
  for (int i = 0; i < 5000; ++i) {
    const double angle = 0.01 * i;
    add_flange(looking_down(0.8 + 0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.6));
  }
  const ToolCheck found = check();
  EXPECT_TRUE(found.possible()) << found.refusal();
  const ToolCheck again = check();
  for (std::size_t i = 0; i < 5000; ++i)
    ASSERT_EQ(found.joints[i], again.joints[i]);
}

}  // namespace
}  // namespace c4g_driver
