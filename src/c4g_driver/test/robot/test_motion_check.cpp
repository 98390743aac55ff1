// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motion_check_test.h"

using c4g_driver::expect_says;
using c4g_driver::Joints;
using c4g_driver::MotionCheckTest;

namespace {

const Joints kUpright = degrees(0, 0, -90, 0, 60, 0);

}  // namespace

TEST_F(MotionCheckTest, LetsPassTheLinesOfAScan) {
  for (const double y : {-0.35, -0.1, 0.2, 0.35}) {
    for (const double z : {0.35, 0.6, 0.75}) {
      Eigen::Isometry3d target = looking_down(0.8, y, z);
      target.rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()));
      for (const bool euler : {false, true}) {
        settings_.euler = euler;
        EXPECT_EQ(refusal_of_pose(target), "") << y << " " << z;
      }
    }
  }
  EXPECT_EQ(check().to_pose(from_.flange).max_override, 100) << "where it stands";
  EXPECT_EQ(check().to_joints(from_.joints).max_override, 100);
}

TEST_F(MotionCheckTest, NamesATargetThatIsOutOfReach) {
  for (const bool in_joints : {false, true}) {
    settings_.in_joints = in_joints;
    const std::string said = refusal_of_pose(looking_down(1.35, 0, 1.5));
    expect_says(said, "target: out of reach by 0.");
    expect_says(said, "nearer to the robot");
  }
}

TEST_F(MotionCheckTest, NamesTheJointThatTheTargetTakesOutOfItsRange) {
  // J1 turns about -z, so it is 0.56 rad here; a robot leaning back over itself needs -2.58
  limits_.joint_lower[0] = -0.3;
  limits_.joint_upper[0] = 0.3;
  for (const bool in_joints : {false, true}) {
    settings_.in_joints = in_joints;
    const std::string said = refusal_of_pose(looking_down(0.8, -0.5, 0.6));
    expect_says(said, "target J1: 0.55");
    expect_says(said, "-0.3 .. 0.3 rad");
  }
}

TEST_F(MotionCheckTest, NamesTheJointThatTheLineTakesOutOfItsRange) {
  // half-way along a chord the flange is nearest to the base, with the arm folded most
  const auto joints = [](double y) {
    return *c4g_driver::step_to(smart5_six(), looking_down(0.55, y, 0.6),
                                c4g_driver::postures_for(smart5_six(), looking_down(0.55, y, 0.6),
                                                         degrees(0, 0, -130, 0, 40, 0))
                                    .joints.front());
  };
  stand(joints(-0.5));
  EXPECT_EQ(refusal_of_pose(looking_down(0.55, 0.5, 0.6)), "");
  limits_.joint_lower[2] = (from_.joints[2] + joints(0)[2]) / 2;
  const std::string said = refusal_of_pose(looking_down(0.55, 0.5, 0.6));
  expect_says(said, "line, J3: ");
  expect_says(said, "% of the way; its range is ");
  const int place = std::stoi(said.substr(said.find(" at ") + 4));
  EXPECT_GT(place, 5);
  EXPECT_LT(place, 50);
}

TEST_F(MotionCheckTest, NamesTheAxesOfASingularPosture) {
  stand(kUpright);
  // turning J5 from 60 to -60 degrees passes the straight wrist
  const Joints end = kUpright - degrees(0, 0, 0, 0, 120, 0);
  const std::string said = refusal_of_pose(flange_by_denavit_hartenberg(end));
  expect_says(said, "line: passes a singular posture of J4 and J6 at ");
  settings_.in_joints = true;
  EXPECT_EQ(refusal_of_pose(flange_by_denavit_hartenberg(end)), "") << "in joints it may";
}

TEST_F(MotionCheckTest, NamesTheJointThatALineAsksTooMuchSpeedOf) {
  Eigen::Isometry3d rolled = from_.flange;  // about the axis of J6: no other joint moves
  rolled.rotate(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitZ()));
  settings_.rotational_speed = 12;
  const std::string said = refusal_of_pose(rolled);
  expect_says(said, "speed of J6: 12 rad/s at ");
  expect_says(said, "the limit is 9.59931 rad/s: set the override to 79.99");
  settings_.override = 79;
  EXPECT_NEAR(check().to_pose(rolled).max_override, 100 * smart5_six().speed()[5] / 12, 1e-6);
}

TEST_F(MotionCheckTest, RefusesALineWhileAFasterSpeedIsSetThanTheCellAllows) {
  settings_.linear_speed = 0.3;
  EXPECT_EQ(refusal_of_pose(looking_down(0.8, 0.2, 0.6)), "");
  limits_.operation = c4g_driver::Operation::kManual;
  const std::string said = refusal_of_pose(looking_down(0.8, 0.2, 0.6));
  expect_says(said, "linear speed set on the controller: 0.3 m/s; first set 0.25 m/s or less: ");
  expect_says(said, "operation is manual");
  limits_.operation = c4g_driver::Operation::kAutomatic;
  from_.mode = c4g_driver::ControllerMode::kProgramming;
  expect_says(refusal_of_pose(looking_down(0.8, 0.2, 0.6)), "in mode programming");
}

TEST_F(MotionCheckTest, HoldsTheFlangeTo250MillimetresASecondInJointsToo) {
  limits_.operation = c4g_driver::Operation::kManual;
  Joints turned = from_.joints;
  turned[0] += 1;  // the flange goes round at 0.8 m
  const double most = 100 * 0.25 / (0.8 * smart5_six().speed()[0]);
  expect_says(refusal_of_joints(turned), "speed of the flange: 1.95");
  settings_.override = most - 0.1;
  EXPECT_NEAR(check().to_joints(turned).max_override, most, 0.01);
  settings_.override = most + 0.1;
  EXPECT_NE(refusal_of_joints(turned), "");
  limits_.operation = c4g_driver::Operation::kAutomatic;
  EXPECT_EQ(check().to_joints(turned).max_override, 100);
}

TEST_F(MotionCheckTest, KeepsTheFlangeInTheBoxOnItsWayInJoints) {
  Joints joints = from_.joints;
  joints[0] = M_PI / 3;  // x = 0.4
  stand(joints);
  Joints other = joints;
  other[0] = -M_PI / 3;
  EXPECT_EQ(refusal_of_joints(other), "");
  limits_.workspace_max.x() = 0.7;  // half-way x is 0.8
  expect_says(refusal_of_joints(other), "way of the flange, x: 0.7");
}

TEST_F(MotionCheckTest, LetsTheRobotComeBackFromOutsideTheBoxAndTheRanges) {
  limits_.workspace_min.z() = 0.7;
  limits_.joint_upper[4] = from_.joints[4] - 0.1;
  EXPECT_EQ(refusal_of_joints(from_.joints - degrees(0, 10, 0, 0, 10, 0)), "");
  EXPECT_NE(refusal_of_joints(from_.joints + degrees(0, 10, 0, 0, 0, 0)), "");
}

TEST_F(MotionCheckTest, RefusesToMoveARobotThatTheModelDoesNotDescribe) {
  from_.flange.translation().z() += 0.25;  // a pedestal, or another type
  const std::string said = refusal_of_joints(from_.joints);
  expect_says(said, "robot description: places the flange 0.25 m and ");
  expect_says(said, "give the URDF of this robot");
}
