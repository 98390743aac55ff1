// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Several motions, checked before the first. The reference is motions of one axis, which move the
/// flange on a circle and turn it along.
#include "c4g_driver/motion_plan.h"
#include "robot/motion_check_test.h"

using c4g_driver::expect_says;
using c4g_driver::Joints;
using c4g_driver::Motion;
using c4g_driver::MotionCheckTest;
using c4g_driver::PlanCheck;
using Eigen::Isometry3d;

namespace {

Motion to(const Isometry3d& flange) {
  Motion motion;
  motion.flange = flange;
  return motion;
}

Motion round(const Isometry3d& via, const Isometry3d& flange) {
  Motion motion = to(flange);
  motion.kind = Motion::Kind::kAlongArc;
  motion.via = via;
  return motion;
}

Motion turned(const Joints& joints) {
  Motion motion;
  motion.kind = Motion::Kind::kToJoints;
  motion.joints = {joints.begin(), joints.end()};
  return motion;
}

class MotionPlanTest : public MotionCheckTest {
 protected:
  MotionPlanTest() { stand(degrees(0, 0, -90, 0, 60, 0)); }

  void plan(const Motion& motion, std::optional<double> speed = {}) {
    plan_.push_back({motion, speed});
  }

  PlanCheck run() const {
    return check_plan(smart5_six(), narrowed(limits_, smart5_six()), from_, settings_, plan_);
  }

  std::vector<c4g_driver::PlannedMotion> plan_;
};

}  // namespace

TEST_F(MotionPlanTest, StartsEachMotionWhereTheOneBeforeEnds) {
  plan(round(at_j5(40), at_j5(20)));
  plan(turned(degrees(100, 0, -90, 0, 70, 0)));
  plan(round(at_j1(120), at_j1(140)));
  const PlanCheck check = run();
  EXPECT_EQ(check.refusal, "");
  EXPECT_FALSE(check.place);
  ASSERT_EQ(check.ends.size(), 3u);
  EXPECT_LT((check.ends[0] - degrees(0, 0, -90, 0, 20, 0)).norm(), 1e-6);
  EXPECT_LT((check.ends[1] - degrees(100, 0, -90, 0, 70, 0)).norm(), 1e-6);
  EXPECT_LT((check.ends[2] - degrees(140, 0, -90, 0, 70, 0)).norm(), 1e-6);
}

TEST_F(MotionPlanTest, SaysWhereALaterMotionPassesASingularPosture) {
  plan(round(at_j5(50), at_j5(40)));
  plan(round(at_j5(10), at_j5(-40)));
  const PlanCheck check = run();
  EXPECT_EQ(check.ends.size(), 1u);
  expect_says(check.refusal, "arc: passes a singular posture of J4 and J6 at ");
  ASSERT_TRUE(check.place);
  EXPECT_NEAR(check.place->way, 0.5, 0.03);  // J5 is 0 after 40 of 80 degrees
  EXPECT_LT((check.place->flange.translation() - at_j5(0).translation()).norm(), 0.01);
}

TEST_F(MotionPlanTest, SaysWhereALaterMotionLeavesTheRangeOfAJoint) {
  plan(turned(degrees(150, 0, -90, 0, 70, 0)));
  plan(round(at_j1(160), at_j1(-160)));  // over 170, the range's end
  const PlanCheck check = run();
  EXPECT_EQ(check.ends.size(), 1u);
  expect_says(check.refusal, "arc, J1: 2.9");
  ASSERT_TRUE(check.place);
  EXPECT_NEAR(check.place->way, 0.4, 0.03);  // 20 of 50 degrees
}

TEST_F(MotionPlanTest, NamesTheTargetThatIsOutOfReach) {
  const Isometry3d far = looking_down(1.35, 0, 1.5);
  plan(to(at_j5(50)));
  plan(to(far));
  const PlanCheck check = run();
  EXPECT_EQ(check.ends.size(), 1u);
  expect_says(check.refusal, "target: out of reach by 0.");
  ASSERT_TRUE(check.place);
  EXPECT_EQ(check.place->way, 1);
  EXPECT_TRUE(check.place->flange.isApprox(far));
}

TEST_F(MotionPlanTest, RefusesWhatIsOutsideTheBoxOrNoMotionWithoutAPlace) {
  plan(to(at_j5(50)));
  plan(to(looking_down(0.8, 0, 0.05)));
  PlanCheck check = run();
  EXPECT_EQ(check.ends.size(), 1u);
  expect_says(check.refusal, "target z: 0.05 m");
  EXPECT_FALSE(check.place);
  plan_[1].motion = turned(degrees(0, 0, -90, 0, 70, 0));
  plan_[1].motion.joints.pop_back();
  expect_says(run().refusal, "target joints: 5 values");
  plan_[1].motion = to(at_j5(50));
  plan_[1].motion.camera_rate = -1;
  expect_says(run().refusal, "camera rate: -1 Hz");
}

TEST_F(MotionPlanTest, ChecksEachMotionAtItsOwnSpeed) {
  const Joints folded = degrees(-60, -30, -140, 0, 80, 0);
  const auto place = [&](double angle) {
    return flange_by_denavit_hartenberg(folded + degrees(angle, 0, 0, 0, 0, 0));
  };
  settings_.rotational_speed = 10;
  plan(turned(folded));
  plan(round(place(20), place(40)), 0.2);
  plan(round(place(60), place(100)), 1.5);  // faster than J1 can move: test_arc_check.cpp
  const PlanCheck check = run();
  EXPECT_EQ(check.ends.size(), 2u);
  expect_says(check.refusal, "speed of J1: ");
  EXPECT_TRUE(check.place);
  limits_.operation = c4g_driver::Operation::kManual;
  settings_.override = 10;
  plan_[2].linear_speed = 0.3;
  EXPECT_EQ(run().ends.size(), 2u);
  expect_says(run().refusal, "linear speed: 0.3 m/s");
}

TEST_F(MotionPlanTest, RefusesToCheckForARobotThatTheModelDoesNotDescribe) {
  from_.flange.translation().z() += 0.25;
  expect_says(refusal([&] { run(); }), "robot description: places the flange 0.25 m and ");
}
