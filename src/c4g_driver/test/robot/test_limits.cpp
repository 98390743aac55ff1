// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "c4g_driver/limits.h"
#include "degree.h"
#include "robot/smart5_six.h"
#include "scan_cell_common/errors/errors.h"

using c4g_driver::RobotLimits;
using scan_cell_common::Refused;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
RobotLimits of_the_robot() {
  return narrowed({}, smart5_six());
}

Eigen::Isometry3d at(double x, double y, double z) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << x, y, z;
  return pose;
}

std::vector<double> joints_in_degrees(std::vector<double> joints) {
  for (double& joint : joints)
    joint *= kDegree;
  return joints;
}

}  // namespace

TEST(Limits, TakeWhatTheRobotCanDo) {
  const RobotLimits limits = of_the_robot();
  EXPECT_NO_THROW(c4g_driver::check_flange(at(0.8, 0, 0.6), limits));
  EXPECT_NO_THROW(
      c4g_driver::check_joints(joints_in_degrees({170, 155, 0, 210, 130, 2700}), limits));
  EXPECT_NO_THROW(
      c4g_driver::check_joints(joints_in_degrees({-170, -85, -170, -210, -130, -2700}), limits));
  EXPECT_NO_THROW(c4g_driver::check_override(100));
  EXPECT_NO_THROW(c4g_driver::check_camera_rate(0, limits));
}

TEST(Limits, RefusePosesThatAreOutsideOrNotFinite) {
  const RobotLimits limits = of_the_robot();
  for (const auto& pose : {at(kNaN, 0, 0.6), at(0.8, kInf, 0.6), at(0.8, 0, -kInf),
                           at(1.41, 0, 0.6), at(0.8, -1.41, 0.6), at(0.8, 0, 0.14)}) {
    EXPECT_THROW(c4g_driver::check_flange(pose, limits), Refused);
  }
  Eigen::Isometry3d mirrored = at(0.8, 0, 0.6);
  mirrored.linear()(2, 2) = -1;
  EXPECT_THROW(c4g_driver::check_flange(mirrored, limits), Refused);
  Eigen::Isometry3d nowhere = at(0.8, 0, 0.6);
  nowhere.linear()(0, 0) = kNaN;
  EXPECT_THROW(c4g_driver::check_flange(nowhere, limits), Refused);
}

TEST(Limits, RefuseJointsBeyondEachEndOfEachRange) {
  const RobotLimits limits = of_the_robot();
  const std::vector<double> middle = {0, 0, -90, 0, 0, 0};
  // the ranges of the data sheet
  const std::vector<double> lower = {-170, -85, -170, -210, -130, -2700};
  const std::vector<double> upper = {170, 155, 0, 210, 130, 2700};
  for (std::size_t i = 0; i < 6; ++i) {
    for (const double bad : {lower[i] - 0.1, upper[i] + 0.1, kNaN, kInf}) {
      std::vector<double> joints = middle;
      joints[i] = bad;
      try {
        c4g_driver::check_joints(joints_in_degrees(joints), limits);
        ADD_FAILURE() << "took J" << i + 1 << " = " << bad;
      } catch (const Refused& refused) {
        EXPECT_EQ(refused.thing(), "target J" + std::to_string(i + 1));
      }
    }
  }
  EXPECT_THROW(c4g_driver::check_joints(joints_in_degrees({0, 0, -90, 0, 0}), limits), Refused);
  EXPECT_THROW(c4g_driver::check_joints({}, limits), Refused);
}

TEST(Limits, RefuseAFlangeOutsideTheBoxWhateverItsOrientation) {
  const RobotLimits limits = of_the_robot();
  EXPECT_NO_THROW(c4g_driver::check_workspace(at(0.8, 0, 0.6), limits));
  for (const auto& pose : {at(kNaN, 0, 0.6), at(1.41, 0, 0.6), at(0.8, 0, 0.14)})
    EXPECT_THROW(c4g_driver::check_workspace(pose, limits), Refused);
}

TEST(Limits, RefuseSpeedsThatMakeNoSense) {
  const RobotLimits limits = of_the_robot();
  const c4g_driver::SpeedLimit limit{1.5, false, ""};
  EXPECT_NO_THROW(c4g_driver::check_linear_speed(1.5, limit));
  for (const double speed : {0.0, -0.1, 1.51, kNaN, kInf})
    EXPECT_THROW(c4g_driver::check_linear_speed(speed, limit), Refused);
  for (const double speed : {1.51, kNaN, kInf})
    EXPECT_THROW(c4g_driver::check_speed_in_force(speed, limit), Refused);
  EXPECT_NO_THROW(c4g_driver::check_speed_in_force(1.5 + 1e-12, limit));
  for (const double percent : {0.0, -1.0, 100.1, kNaN})
    EXPECT_THROW(c4g_driver::check_override(percent), Refused);
  EXPECT_NO_THROW(c4g_driver::check_override(30, 30));
  EXPECT_THROW(c4g_driver::check_override(31, 30), Refused);
  for (const double rate : {-1.0, kNaN, kInf})
    EXPECT_THROW(c4g_driver::check_camera_rate(rate, limits), Refused);
}

TEST(Limits, AllowMoreThan250MillimetresASecondOnlyWhereCellAndControllerAreAutomatic) {
  RobotLimits limits;  // the safe ones
  c4g_driver::RobotState remote, programming;
  remote.mode = c4g_driver::ControllerMode::kRemote;
  programming.mode = c4g_driver::ControllerMode::kProgramming;
  for (const auto* state : {&remote, &programming, static_cast<c4g_driver::RobotState*>(nullptr)}) {
    EXPECT_EQ(c4g_driver::speed_limit(limits, state).most, 0.25);
    EXPECT_TRUE(c4g_driver::speed_limit(limits, state).reduced);
  }
  limits.operation = c4g_driver::Operation::kAutomatic;
  EXPECT_EQ(c4g_driver::speed_limit(limits, &remote).most, 1.5);
  EXPECT_FALSE(c4g_driver::speed_limit(limits, &remote).reduced);
  EXPECT_EQ(c4g_driver::speed_limit(limits, &programming).most, 0.25);
  limits.max_linear_speed = 0.1;
  EXPECT_EQ(c4g_driver::speed_limit(limits, &programming).most, 0.1);
  EXPECT_EQ(c4g_driver::speed_limit(limits, &remote).most, 0.1);
}

TEST(Limits, NarrowTheRangesOfTheRobotAndNeverWidenThem) {
  RobotLimits limits;
  limits.joint_lower[0] = -0.5;
  limits.joint_upper[0] = 100;
  const RobotLimits both = narrowed(limits, smart5_six());
  EXPECT_EQ(both.joint_lower[0], -0.5);
  EXPECT_NEAR(both.joint_upper[0], 170 * kDegree, 1e-9);
  limits.joint_lower[0] = 3;
  EXPECT_THROW(narrowed(limits, smart5_six()), scan_cell_common::InvalidParameter);
}
