// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/pose/euler_angles.h"
#include "text/rotation_vector.h"

namespace tool_path_programs {
namespace {

double angle_between(const Eigen::Matrix3d& one, const Eigen::Matrix3d& other) {
  return Eigen::Quaterniond(one).angularDistance(Eigen::Quaterniond(other));
}

/// R = Rz(yaw) Ry(pitch) Rx(roll), from the script manual's definition of RPY.
Eigen::Matrix3d rpy(double roll, double pitch, double yaw) {
  return scan_cell_common::EulerSequence("zyx").rotation({yaw, pitch, roll});
}

// Examples of the functions rpy2rotvec and rotvec2rpy in the script manual of the e-Series (5.x).
TEST(RotationVector, IsThatOfTheManualsExamples) {
  const Eigen::Vector3d vector = rotation_vector(rpy(3.14, 1.57, 0));
  EXPECT_LT((vector - Eigen::Vector3d(2.22153, 0.00177, -2.21976)).norm(), 2e-5);
  EXPECT_LT(angle_between(rotation_of({2.22153, 0.00177, -2.21976}), rpy(3.14, 1.57, 0)), 2e-5);
  EXPECT_LT(angle_between(rotation_of({3.14, 1.57, 0}), rpy(-2.80856, -0.16202, 0.9)), 2e-5);
}

TEST(RotationVector, HasItsClosedFormsAtAndNearNoTurnAndHalfATurn) {
  EXPECT_TRUE(rotation_vector(Eigen::Matrix3d::Identity()).isZero(0));
  EXPECT_TRUE(rotation_of(Eigen::Vector3d::Zero()).isIdentity(0));
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, -1, 0),
                                      Eigen::Vector3d(0.6, 0, -0.8), Eigen::Vector3d(-0.8, 0.6, 0)})
    for (const double angle : {1e-12, 1e-8, 1e-4, 1.0, M_PI - 1e-4, M_PI - 1e-8})
      EXPECT_LT((rotation_vector(Eigen::AngleAxisd(angle, axis).toRotationMatrix()) - angle * axis)
                    .norm(),
                1e-9)
          << angle << " about " << axis.transpose();
}

TEST(RotationVector, AtHalfATurnItIsOneOfTheTwo) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, -1, 0).normalized();
  const Eigen::Vector3d vector = rotation_vector(Eigen::AngleAxisd(M_PI, axis).toRotationMatrix());
  EXPECT_NEAR(std::abs(vector.dot(axis)), M_PI, 1e-9);  // +-[2.2214, -2.2214, 0]
}

TEST(RotationVector, StaysOnTheSideOfTheOldOne) {
  const Eigen::Vector3d beyond(3.9322, 1.6518, 1.6554);  // 4.57 rad, from a public program
  EXPECT_LT((rotation_vector_near(rotation_of(beyond), beyond) - beyond).norm(), 1e-9);
  const Eigen::Vector3d half(0, -M_PI, 0);
  EXPECT_LT((rotation_vector_near(rotation_of({0, M_PI - 1e-3, 0}), half) -
             Eigen::Vector3d(0, -M_PI - 1e-3, 0))
                .norm(),
            1e-9);
}

}  // namespace
}  // namespace tool_path_programs
