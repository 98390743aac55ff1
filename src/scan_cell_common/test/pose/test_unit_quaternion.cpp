// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "scan_cell_common/pose/unit_quaternion.h"

using Eigen::Quaterniond;
using scan_cell_common::is_unit;
using scan_cell_common::rotation_from;

TEST(UnitQuaternion, MayBeRoundedAndComesBackAsARotation) {
  EXPECT_TRUE(is_unit(Quaterniond(0.7071, 0, 0.7071, 0)));
  EXPECT_TRUE(is_unit(Quaterniond(1.0009, 0, 0, 0)));
  const Eigen::Matrix3d turn = rotation_from(Quaterniond(0.7071, 0, 0.7071, 0), "pose");
  EXPECT_TRUE((turn * turn.transpose()).isIdentity(1e-12));
  EXPECT_TRUE((turn * Eigen::Vector3d::UnitX()).isApprox(-Eigen::Vector3d::UnitZ(), 1e-12));
}

TEST(UnitQuaternion, IsRefusedByItsLengthWithTheKindOfErrorAskedFor) {
  EXPECT_FALSE(is_unit(Quaterniond(0, 0, 0, 0)));
  EXPECT_FALSE(is_unit(Quaterniond(1.0011, 0, 0, 0)));
  EXPECT_FALSE(is_unit(Quaterniond(std::nan(""), 0, 0, 0)));
  try {
    rotation_from<scan_cell_common::InvalidParameter>(Quaterniond(0.5, 0, 0, 0), "start");
    FAIL();
  } catch (const scan_cell_common::InvalidParameter& error) {
    EXPECT_STREQ(error.what(),
                 "start: a quaternion of length 0.5; give a unit quaternion qx qy qz qw");
  }
}
