// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <future>
#include <random>
#include <vector>

#include "robot/closed_form.h"
#include "robot/inverse_kinematics.h"
#include "robot/smart5_six.h"
#include "scan_cell_common/errors/errors.h"

using c4g_driver::Joints;
using c4g_driver::RobotModel;

namespace {

Joints within_the_ranges(std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  Joints joints;
  for (int i = 0; i < 6; ++i) {
    const double lower = std::max(smart5_six().lower()[i], -3.0);
    joints[i] = lower + share(random) * (std::min(smart5_six().upper()[i], 3.0) - lower);
  }
  return joints;
}

std::string complaint(std::string urdf, const std::string& from, const std::string& to,
                      const std::string& base = "base_link") {
  const auto place = urdf.find(from);
  EXPECT_NE(place, std::string::npos);
  urdf.replace(place, from.size(), to);
  try {
    const RobotModel robot(urdf, base, "flange");
  } catch (const scan_cell_common::InvalidParameter& error) {
    return error.value();
  }
  return "";
}

/// Whether the model gives the right position and motion of the flange, again and again.
bool right_of(const Joints& joints) {
  constexpr int kTimes = 20000;
  constexpr double kTolerance = 1e-9;
  const auto flange = flange_by_denavit_hartenberg(joints);
  const RobotModel::Jacobian jacobian = smart5_six().jacobian_at(joints);
  for (int i = 0; i < kTimes; ++i) {
    if (!smart5_six().flange_at(joints).isApprox(flange, kTolerance)) return false;
    if (!smart5_six().jacobian_at(joints).isApprox(jacobian, kTolerance)) return false;
  }
  return true;
}

}  // namespace

TEST(RobotModel, PutsTheFlangeWhereTheDataSheetPutsIt) {
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    const Joints joints = within_the_ranges(random);
    EXPECT_TRUE(
        smart5_six().flange_at(joints).isApprox(flange_by_denavit_hartenberg(joints), 1e-12));
  }
}

TEST(RobotModel, GivesTheVelocityOfTheFlange) {
  std::mt19937 random(5);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 50; ++i) {
    const Joints joints = within_the_ranges(random);
    const RobotModel::Jacobian jacobian = smart5_six().jacobian_at(joints);
    for (int k = 0; k < 6; ++k) {
      const Joints step = kStep * Joints::Unit(k);
      const auto change = c4g_driver::twist(flange_by_denavit_hartenberg(joints - step),
                                            flange_by_denavit_hartenberg(joints + step));
      EXPECT_LT((jacobian.col(k) - change / (2 * kStep)).norm(), 1e-7);
    }
  }
}

TEST(RobotModel, AnswersEachOfSeveralThreadsForItsOwnJoints) {
  std::mt19937 random(7);
  std::vector<std::future<bool>> threads(4);
  for (auto& thread : threads)
    thread = std::async(std::launch::async, right_of, within_the_ranges(random));
  for (auto& thread : threads)
    EXPECT_TRUE(thread.get());
}

TEST(RobotModel, HasTheRangesAndSpeedsOfTheDataSheet) {
  EXPECT_LT((smart5_six().lower() - degrees(-170, -85, -170, -210, -130, -2700)).norm(), 1e-9);
  EXPECT_LT((smart5_six().upper() - degrees(170, 155, 0, 210, 130, 2700)).norm(), 1e-9);
  EXPECT_LT((smart5_six().speed() - degrees(140, 160, 170, 450, 375, 550)).norm(), 1e-9);
  EXPECT_EQ(smart5_six().joint_names().front(), "joint_1");
  EXPECT_EQ(smart5_six().joint_names().back(), "joint_6");
}

TEST(RobotModel, IsThatOfWhateverUrdfItIsGiven) {
  std::string urdf = scan_cell_common::read_file(URDF_FILE);
  const std::string shoulder = "xyz=\"0 0 0.300\"";  // of joint 1
  urdf.replace(urdf.find(shoulder), shoulder.size(), "xyz=\"0 0 0.550\"");
  const RobotModel taller(urdf, "base_link", "flange");
  const Joints joints = degrees(10, 20, -80, 30, 40, 50);
  const Eigen::Vector3d up =
      taller.flange_at(joints).translation() - flange_by_denavit_hartenberg(joints).translation();
  EXPECT_TRUE(up.isApprox(Eigen::Vector3d(0, 0, 0.25), 1e-9));
}

TEST(RobotModel, RefusesWhatDescribesNoArmOfSix) {
  const std::string urdf = scan_cell_common::read_file(URDF_FILE);
  EXPECT_NE(complaint("<robot", "<robot", "<nothing").find("<nothing"), std::string::npos);
  EXPECT_NE(complaint(urdf, "<robot", "<robot", "world").find("'world'"), std::string::npos);
  EXPECT_EQ(complaint(urdf, "name=\"joint_4\" type=\"revolute\"", "name=\"joint_4\" type=\"fixed\"")
                .substr(0, 15),
            "5 moving joints");
  EXPECT_EQ(
      complaint(urdf, "name=\"joint_4\" type=\"revolute\"", "name=\"joint_4\" type=\"prismatic\""),
      "joint_4 does not turn");
  EXPECT_EQ(complaint(urdf, "velocity=\"7.853981633974483\"", "velocity=\"0\""),
            "joint_4 has no range or no speed");
}

TEST(InverseKinematics, FollowAPoseFromNearby) {
  std::mt19937 random(7);
  std::normal_distribution<double> off(0, 0.01);
  int followed = 0;
  for (int i = 0; i < 200; ++i) {
    const Joints joints = within_the_ranges(random);
    Joints near = joints;
    for (double& joint : near)
      joint += off(random);
    const auto found =
        c4g_driver::step_to(smart5_six(), flange_by_denavit_hartenberg(joints), near);
    if (std::abs(joints[4]) < 0.05 || !found) continue;  // a straight wrist
    EXPECT_LT((*found - joints).norm(), 1e-4);
    ++followed;
  }
  EXPECT_GT(followed, 180);
}

TEST(InverseKinematics, FindAPostureForEachPoseTheRobotCanTakeUp) {
  std::mt19937 random(9);
  for (int i = 0; i < 60; ++i) {
    const Eigen::Isometry3d pose = flange_by_denavit_hartenberg(within_the_ranges(random));
    const auto found = c4g_driver::postures_for(smart5_six(), pose, Joints::Zero());
    double least = 1;
    for (const Joints& joints : found.joints) {
      EXPECT_TRUE(flange_by_denavit_hartenberg(joints).isApprox(pose, 1e-7));
      least =
          std::min(least, c4g_driver::excess(joints, smart5_six().lower(), smart5_six().upper()));
    }
    EXPECT_EQ(least, 0) << "pose " << i << ", " << found.joints.size() << " postures";
  }
}

TEST(InverseKinematics, SayHowFarAPoseIsOutOfReach) {
  // The arm reaches 0.59 + |(0.64707, 0.13)| from its shoulder to the wrist, and 0.095 on.
  const Eigen::Vector3d shoulder(0.15, 0, 0.45);
  const double wrist = 0.59 + std::hypot(0.64707, 0.13);
  for (const auto& place : {Eigen::Vector3d(1.35, 0, 1.5), Eigen::Vector3d(2.5, 0, 0.4)}) {
    const auto found = c4g_driver::postures_for(
        smart5_six(), looking_down(place.x(), place.y(), place.z()), Joints::Zero());
    EXPECT_TRUE(found.joints.empty());
    // at best with the flange turned to it, at worst still looking down
    const double best = (place - shoulder).norm() - wrist - 0.095;
    const double worst = (place + Eigen::Vector3d(0, 0, 0.095) - shoulder).norm() - wrist;
    EXPECT_GT(found.gap, best - 1e-3);
    EXPECT_LT(found.gap, worst + 0.05);
  }
}
