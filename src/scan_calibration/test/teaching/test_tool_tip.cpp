// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scan_cell_common/errors/errors.h"
#include "teaching/tool_tip.h"

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using scan_calibration::tool_tip_from_poses;
using scan_calibration::ToolTip;
using scan_calibration::ToolTipLimits;

namespace {

const Vector3d kTip(0.01, -0.02, 0.2);
const Vector3d kPoint(0.9, 0.1, 0.05);
constexpr double kDegree = M_PI / 180;

/// The flange's pose with this orientation and the tip on the point.
Isometry3d touching(const Eigen::Quaterniond& rotation) {
  return Eigen::Translation3d(kPoint - rotation * kTip) * rotation;
}

/// Poses pointing down, tilted by `tilt` towards each of `count` directions.
std::vector<Isometry3d> touching_around(int count, double tilt) {
  std::vector<Isometry3d> poses;
  for (int i = 0; i < count; ++i) {
    const double direction = 2 * M_PI * i / count;
    const Vector3d axis(std::cos(direction), std::sin(direction), 0);
    poses.push_back(touching(Eigen::Quaterniond(AngleAxisd(tilt, axis)) *
                             Eigen::Quaterniond(AngleAxisd(M_PI, Vector3d::UnitX()))));
  }
  return poses;
}

std::string refused(const std::vector<Isometry3d>& poses) {
  try {
    tool_tip_from_poses(poses);
  } catch (const scan_cell_common::UnusableInput& error) {
    return error.what();
  }
  return "nothing";
}

}  // namespace

TEST(ToolTip, IsTheOneThatTouchesThePointFromThreeOrientations) {
  const ToolTip found = tool_tip_from_poses(touching_around(3, 25 * kDegree));
  EXPECT_LT((found.tip - kTip).norm(), 1e-12);
  EXPECT_LT((found.fixed_point - kPoint).norm(), 1e-12);
  EXPECT_LT(found.worst_residual, 1e-12);
}

TEST(ToolTip, SaysHowFarItScatters) {
  constexpr double kNoise = 2e-4;
  constexpr int kTrials = 400;
  std::mt19937 generator(1);
  std::normal_distribution<double> noise(0, kNoise);
  Vector3d squares = Vector3d::Zero(), claimed = Vector3d::Zero();
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<Isometry3d> poses = touching_around(8, 25 * kDegree);
    for (Isometry3d& pose : poses) {
      pose.pretranslate(Vector3d(noise(generator), noise(generator), noise(generator)));
    }
    const ToolTip found = tool_tip_from_poses(poses);
    squares += (found.tip - kTip).cwiseAbs2() / kTrials;
    claimed += found.deviation.cwiseAbs2() / kTrials;
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(std::sqrt(claimed[axis]) / std::sqrt(squares[axis]), 1, 0.1) << axis;
  }
}

TEST(ToolTip, IsRefusedFromFewerThanThreePoses) {
  EXPECT_NE(refused(touching_around(2, 25 * kDegree)).find("poses of the tool: 2;"),
            std::string::npos);
}

TEST(ToolTip, IsRefusedWhereTheOrientationsLeaveItOpen) {
  const Isometry3d same = touching(Eigen::Quaterniond::Identity());
  EXPECT_NE(refused({same, same, same, same}).find("condition number"), std::string::npos);
  std::vector<Isometry3d> about_one_axis;
  for (const double angle : {0.0, 0.5, 1.0, 1.5}) {
    about_one_axis.push_back(
        touching(Eigen::Quaterniond(AngleAxisd(angle, Vector3d(1, 1, 0).normalized()))));
  }
  EXPECT_NE(refused(about_one_axis).find("condition number"), std::string::npos);
  EXPECT_NE(refused(touching_around(6, 1 * kDegree)).find("condition number"), std::string::npos);
}

TEST(ToolTip, GivesTheConditionNumberOfItsClosedForm) {
  // A^T A has the eigenvalues n (1 +- s) with s the singular values of the mean rotation: here
  // (1 + cos tilt) / 2 twice and cos tilt.
  for (const double tilt : {10 * kDegree, 20 * kDegree, 30 * kDegree}) {
    const double mean = (1 + std::cos(tilt)) / 2;
    EXPECT_NEAR(tool_tip_from_poses(touching_around(6, tilt)).condition,
                std::sqrt((1 + mean) / (1 - mean)), 1e-9);
  }
}

TEST(ToolTip, IsRefusedWithTheNumberOfThePoseThatMisses) {
  std::vector<Isometry3d> poses = touching_around(6, 25 * kDegree);
  poses[3].pretranslate(Vector3d(0, 0.01, 0));
  EXPECT_NE(refused(poses).find("pose 4 of the tool: misses the fixed point by"), std::string::npos)
      << refused(poses);
}
