// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "degree.h"
#include "wire/wire_units.h"

using c4g_driver::WireSix;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using scan_cell_common::comau_angles;

namespace {

Matrix3d rz(double angle) {
  Matrix3d m;
  m << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
  return m;
}

Matrix3d ry(double angle) {
  Matrix3d m;
  m << std::cos(angle), 0, std::sin(angle), 0, 1, 0, -std::sin(angle), 0, std::cos(angle);
  return m;
}

/// Columns are the flange's axes in the base.
Matrix3d axes(const Vector3d& x, const Vector3d& z) {
  Matrix3d m;
  m << x, z.cross(x), z;
  return m;
}

void expect_same(const Matrix3d& a, const Matrix3d& b, double tolerance) {
  EXPECT_LT((a - b).norm(), tolerance) << a << "\n\n" << b;
}

}  // namespace

TEST(EulerAngles, AreThoseOfTheProtocolsTable) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const std::vector<std::pair<WireSix, Matrix3d>> table = {
      {{0, 0, 0, 0, 0, 0}, Matrix3d::Identity()}, {{0, 0, 0, 0, 180, 180}, axes(x, -z)},
      {{0, 0, 0, 90, 180, -90}, axes(x, -z)},     {{0, 0, 0, 0, 180, 90}, axes(y, -z)},
      {{0, 0, 0, 0, 90, 0}, axes(-z, x)},         {{0, 0, 0, 90, 90, 0}, axes(-z, y)}};
  for (const auto& [wire, rotation] : table) {
    expect_same(c4g_driver::pose_from_wire(wire).linear(), rotation, 1e-12);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = rotation;
    expect_same(c4g_driver::pose_from_wire(c4g_driver::to_wire(pose)).linear(), rotation, 1e-12);
  }
}

TEST(EulerAngles, AreTheProductOfThreeTurns) {
  for (double a = -170; a < 180; a += 35) {
    for (double e = 10; e < 180; e += 25) {
      for (double r = -175; r < 180; r += 50) {
        const Matrix3d product = rz(a * kDegree) * ry(e * kDegree) * rz(r * kDegree);
        const auto angles = comau_angles().angles(product);
        EXPECT_NEAR(angles[0], a * kDegree, 1e-12);
        EXPECT_NEAR(angles[1], e * kDegree, 1e-12);
        EXPECT_NEAR(angles[2], r * kDegree, 1e-12);
        expect_same(comau_angles().rotation({a * kDegree, e * kDegree, r * kDegree}), product,
                    1e-12);
      }
    }
  }
}

TEST(EulerAngles, LoseNothingAtAndNearTheirDegenerateEnds) {
  for (const double e : {0.0, 1e-15, 1e-13, 1e-12, 1e-9, 1e-6, M_PI - 1e-6, M_PI - 1e-9,
                         M_PI - 1e-12, M_PI - 1e-13, M_PI}) {
    for (double a = -3; a < 3.1; a += 0.7) {
      for (double r = -3; r < 3.1; r += 0.7) {
        const Matrix3d product = rz(a) * ry(e) * rz(r);
        const auto angles = comau_angles().angles(product);
        EXPECT_GE(angles[1], 0);
        EXPECT_LE(angles[1], M_PI);
        expect_same(rz(angles[0]) * ry(angles[1]) * rz(angles[2]), product, 5e-12);
      }
    }
  }
}

TEST(EulerAngles, HaveNoFirstTurnWhereOnlyTheSumIsDefined) {
  EXPECT_EQ(comau_angles().angles(rz(0.5))[0], 0);
  EXPECT_NEAR(comau_angles().angles(rz(0.5))[2], 0.5, 1e-15);
  const Matrix3d down = Vector3d(1, -1, -1).asDiagonal();
  EXPECT_EQ(comau_angles().angles(down)[0], 0);
  EXPECT_NEAR(std::abs(comau_angles().angles(down)[2]), M_PI, 1e-15);
}

TEST(WireUnits, KeepTheAnglesInTheRangesThatAreSent) {
  for (const double a : {-180.0, -90.0, 0.0, 180.0}) {
    for (const double e : {0.0, 90.0, 180.0}) {
      for (const double r : {-180.0, 0.0, 90.0, 180.0}) {
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.linear() = rz(a * kDegree) * ry(e * kDegree) * rz(r * kDegree);
        for (int i = 0; i < 9; ++i) {  // the signs of zeros decide between 180 and -180
          double& entry = pose.linear()(i / 3, i % 3);
          if (std::abs(entry) < 1e-15) entry = std::copysign(0.0, i % 2 == 0 ? 1 : -1);
        }
        const WireSix wire = c4g_driver::to_wire(pose);
        EXPECT_TRUE(wire[3] > -180 && wire[3] <= 180) << wire[3];
        EXPECT_TRUE(wire[4] >= 0 && wire[4] <= 180) << wire[4];
        EXPECT_TRUE(wire[5] > -180 && wire[5] <= 180) << wire[5];
        EXPECT_TRUE(wire[3] == 0 || e == 90) << wire[3];
      }
    }
  }
}

TEST(WireUnits, AreMillimetresAndDegrees) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << 0.8, -0.02, 0.6;
  EXPECT_EQ(c4g_driver::to_wire(pose), (WireSix{800, -20, 600, 0, 0, 0}));
  c4g_driver::Joints joints;
  joints << 0, M_PI / 2, -M_PI, 0.1, 0, -47;
  const WireSix wire = c4g_driver::to_wire(joints);
  EXPECT_NEAR(wire[1], 90, 1e-12);
  EXPECT_NEAR(wire[2], -180, 1e-12);
  EXPECT_TRUE(c4g_driver::joints_from_wire(wire).isApprox(joints, 1e-15));
}
