// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>

#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_sim/controller/kinematics.h"
#include "scan_cell_sim/controller/refusal.h"

/// The ground truth for the tests of the emulated controller's motions.

constexpr scan_cell_common::Nanoseconds kStart = 1'700'000'000'000'000'000;  // of the host
constexpr double kDegree = M_PI / 180;

inline scan_cell_sim::Joints degrees(double a, double b, double c, double d, double e, double f) {
  return kDegree * (scan_cell_sim::Joints() << a, b, c, d, e, f).finished();
}

inline Eigen::Isometry3d looking_down(double x, double y, double z) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << x, y, z;
  pose.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  return pose;
}

/// Product of exponentials (Lynch and Park 2017) from the data sheet's lengths. Each axis is where
/// it lies with all joints at zero and the arm upright.
inline Eigen::Isometry3d product_of_exponentials(const scan_cell_sim::Joints& q) {
  const Eigen::Vector3d shoulder(0.150, 0, 0.450);
  const Eigen::Vector3d elbow = shoulder + Eigen::Vector3d(0, 0, 0.590);
  const Eigen::Vector3d wrist = elbow + Eigen::Vector3d(-0.130, 0, 0.64707);
  const std::array<Eigen::Vector3d, 6> axes = {
      -Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitY(),
      -Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitZ()};
  const std::array<Eigen::Vector3d, 6> points = {
      Eigen::Vector3d::Zero(), shoulder, elbow, wrist, wrist, wrist};
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 6; ++i)
    pose = pose * Eigen::Translation3d(points[i]) * Eigen::AngleAxisd(q[i], axes[i]) *
           Eigen::Translation3d(-points[i]);
  Eigen::Isometry3d home = Eigen::Isometry3d::Identity();
  home.translation() = wrist + Eigen::Vector3d(0, 0, 0.095);
  home.linear() = Eigen::Vector3d(-1, -1, 1).asDiagonal();
  return pose * home;
}

/// @param tolerance [m] and [rad]
inline void expect_same(const Eigen::Isometry3d& pose, const Eigen::Isometry3d& expected,
                        double tolerance) {
  EXPECT_LT((pose.translation() - expected.translation()).norm(), tolerance);
  EXPECT_LT(Eigen::AngleAxisd(pose.linear().transpose() * expected.linear()).angle(), tolerance);
}

inline scan_cell_sim::ControllerErrorCode refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const scan_cell_sim::ControllerRefusal& refused) {
    return refused.code();
  }
  ADD_FAILURE() << "was not refused";
  return scan_cell_sim::ControllerErrorCode::kMalformed;
}
