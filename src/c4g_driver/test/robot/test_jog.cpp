// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "c4g_driver/jog.h"
#include "robot/closed_form.h"

namespace c4g_driver {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

RobotState standing() {
  RobotState state;
  state.joints << 0.1, 0.2, -1.9, 0.3, 0.8, -0.4;
  state.flange = flange_by_denavit_hartenberg(state.joints);
  return state;
}

TEST(Jog, MovesOneJointAlone) {
  const Motion motion = jog_motion(standing(), {Jog::Kind::kJoint, 3, -1}, 0.5);
  EXPECT_EQ(motion.kind, Motion::Kind::kToJoints);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(motion.joints.at(static_cast<std::size_t>(i)),
                standing().joints[i] - (i == 3 ? M_PI / 4 : 0), 1e-12);
}

TEST(Jog, MovesAndTurnsTheFlangeInTheBase) {
  const Isometry3d from = standing().flange;
  const Isometry3d moved = jog_motion(standing(), {Jog::Kind::kBase, 1, 1}, 0.1).flange;
  EXPECT_TRUE(moved.translation().isApprox(from.translation() + Vector3d(0, 0.05, 0), 1e-12));
  EXPECT_TRUE(moved.linear().isApprox(from.linear(), 1e-12));
  const Isometry3d turned = jog_motion(standing(), {Jog::Kind::kBase, 5, -1}, 1).flange;
  EXPECT_TRUE(turned.translation().isApprox(from.translation(), 1e-12)) << "about the flange";
  EXPECT_TRUE(turned.linear().isApprox(
      AngleAxisd(-M_PI / 2, Vector3d::UnitZ()).toRotationMatrix() * from.linear(), 1e-12));
}

TEST(Jog, MovesAndTurnsTheFlangeAlongItsOwnAxes) {
  const Isometry3d from = standing().flange;
  const Isometry3d moved = jog_motion(standing(), {Jog::Kind::kFlange, 2, -1}, 1).flange;
  EXPECT_TRUE(moved.translation().isApprox(from.translation() - 0.5 * from.linear().col(2), 1e-12));
  const Isometry3d turned = jog_motion(standing(), {Jog::Kind::kFlange, 3, 1}, 1).flange;
  EXPECT_TRUE(turned.linear().col(0).isApprox(from.linear().col(0), 1e-12));
  EXPECT_TRUE(turned.linear().col(1).isApprox(from.linear().col(2), 1e-12));
}

TEST(Jog, RefusesWhatIsNoAxisOrNoDirection) {
  EXPECT_THROW(jog_motion(standing(), {Jog::Kind::kJoint, 6, 1}, 1), scan_cell_common::Refused);
  EXPECT_THROW(jog_motion(standing(), {Jog::Kind::kBase, -1, 1}, 1), scan_cell_common::Refused);
  EXPECT_THROW(jog_motion(standing(), {Jog::Kind::kBase, 0, 0}, 1), scan_cell_common::Refused);
}

}  // namespace
}  // namespace c4g_driver
