// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "c4g_driver/kinematics.h"
#include "c4g_driver/limits.h"
#include "closed_form.h"
#include "scan_cell_common/errors.h"

using c4g_driver::RobotLimits;
using scan_cell_common::Refused;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kDegree = M_PI / 180;

Eigen::Isometry3d at(double x, double y, double z) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << x, y, z;
  return pose;
}

std::vector<double> degrees(std::vector<double> joints) {
  for (double& joint : joints)
    joint *= kDegree;
  return joints;
}

}  // namespace

TEST(Limits, TakeWhatTheRobotCanDo) {
  const RobotLimits limits;
  EXPECT_NO_THROW(c4g_driver::check_flange(at(0.8, 0, 0.6), limits));
  EXPECT_NO_THROW(c4g_driver::check_joints(degrees({170, 155, 0, 210, 130, 2700}), limits));
  EXPECT_NO_THROW(c4g_driver::check_joints(degrees({-170, -85, -170, -210, -130, -2700}), limits));
  EXPECT_NO_THROW(c4g_driver::check_linear_speed(1.5, limits));
  EXPECT_NO_THROW(c4g_driver::check_override(100));
  EXPECT_NO_THROW(c4g_driver::check_camera_rate(0, limits));
}

TEST(Limits, RefusePosesThatAreOutsideOrNotFinite) {
  const RobotLimits limits;
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
  const RobotLimits limits;
  const std::vector<double> middle = {0, 0, -90, 0, 0, 0};
  // the ranges of the data sheet
  const std::vector<double> lower = {-170, -85, -170, -210, -130, -2700};
  const std::vector<double> upper = {170, 155, 0, 210, 130, 2700};
  for (std::size_t i = 0; i < 6; ++i) {
    for (const double bad : {lower[i] - 0.1, upper[i] + 0.1, kNaN, kInf}) {
      std::vector<double> joints = middle;
      joints[i] = bad;
      try {
        c4g_driver::check_joints(degrees(joints), limits);
        ADD_FAILURE() << "took J" << i + 1 << " = " << bad;
      } catch (const Refused& refused) {
        EXPECT_EQ(refused.thing(), "target J" + std::to_string(i + 1));
      }
    }
  }
  EXPECT_THROW(c4g_driver::check_joints(degrees({0, 0, -90, 0, 0}), limits), Refused);
  EXPECT_THROW(c4g_driver::check_joints({}, limits), Refused);
}

TEST(Limits, RefuseAFlangeOutsideTheBoxWhateverItsOrientation) {
  const RobotLimits limits;
  EXPECT_NO_THROW(c4g_driver::check_workspace(at(0.8, 0, 0.6), limits));
  for (const auto& pose : {at(kNaN, 0, 0.6), at(1.41, 0, 0.6), at(0.8, 0, 0.14)})
    EXPECT_THROW(c4g_driver::check_workspace(pose, limits), Refused);
}

TEST(Kinematics, PutTheFlangeWhereTheDataSheetPutsIt) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (int i = 0; i < 200; ++i) {
    c4g_driver::Joints joints;
    for (double& joint : joints)
      joint = angle(random);
    EXPECT_TRUE(
        c4g_driver::flange_at(joints).isApprox(flange_by_denavit_hartenberg(joints), 1e-12));
  }
}

TEST(Limits, RefuseSpeedsThatMakeNoSense) {
  const RobotLimits limits;
  for (const double speed : {0.0, -0.1, 1.51, kNaN, kInf})
    EXPECT_THROW(c4g_driver::check_linear_speed(speed, limits), Refused);
  for (const double speed : {1.51, kNaN, kInf})
    EXPECT_THROW(c4g_driver::check_speed_in_force(speed, limits), Refused);
  EXPECT_NO_THROW(c4g_driver::check_speed_in_force(1.5 + 1e-12, limits));
  for (const double percent : {0.0, -1.0, 100.1, kNaN})
    EXPECT_THROW(c4g_driver::check_override(percent), Refused);
  for (const double rate : {-1.0, kNaN, kInf})
    EXPECT_THROW(c4g_driver::check_camera_rate(rate, limits), Refused);
}
