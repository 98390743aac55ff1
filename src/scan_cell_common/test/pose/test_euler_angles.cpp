// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/euler_angles.h"

using scan_cell_common::EulerSequence;

namespace {

const char* const kSequences[] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx",
                                  "xyx", "xzx", "yxy", "yzy", "zxz", "zyz"};

constexpr double kDegree = M_PI / 180;

Eigen::Matrix3d turn(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

}  // namespace

TEST(EulerAngles, TurnAboutTheAxesThatTheTurnsBeforeLeft) {
  const Eigen::Vector3d angles(0.3, -0.7, 1.1);
  const Eigen::Matrix3d zyx = turn(0.3, Eigen::Vector3d::UnitZ()) *
                              turn(-0.7, Eigen::Vector3d::UnitY()) *
                              turn(1.1, Eigen::Vector3d::UnitX());
  EXPECT_TRUE(EulerSequence("zyx").rotation(angles).isApprox(zyx, 1e-14));
  const Eigen::Matrix3d zyz = turn(0.3, Eigen::Vector3d::UnitZ()) *
                              turn(-0.7, Eigen::Vector3d::UnitY()) *
                              turn(1.1, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(EulerSequence("ZYZ").rotation(angles).isApprox(zyz, 1e-14));
}

TEST(EulerAngles, OfEverySequenceComeBack) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-0.999 * M_PI, 0.999 * M_PI);
  for (const char* const axes : kSequences) {
    const EulerSequence sequence(axes);
    for (int run = 0; run < 200; ++run) {
      Eigen::Vector3d given(angle(random), angle(random), angle(random));
      given[1] = sequence.repeats() ? std::abs(given[1]) : given[1] / 2;
      EXPECT_TRUE(sequence.angles(sequence.rotation(given)).isApprox(given, 1e-9)) << axes;
    }
  }
}

TEST(EulerAngles, GiveTheRotationBackWhereTwoAxesLieInOneLine) {
  for (const char* const axes : kSequences) {
    const EulerSequence sequence(axes);
    for (const double off : {0.0, 1e-15, 1e-13, 1e-9, 1e-5}) {
      const double middle = sequence.repeats() ? M_PI : M_PI / 2;
      for (const double second : {middle - off, sequence.repeats() ? off : off - middle}) {
        const Eigen::Matrix3d rotation = sequence.rotation({2.5, second, -1.9});
        const Eigen::Vector3d angles = sequence.angles(rotation);
        EXPECT_TRUE(sequence.rotation(angles).isApprox(rotation, 1e-9)) << axes << ' ' << off;
        if (off == 0) {
          EXPECT_EQ(angles[0], 0) << axes;
        }
      }
    }
  }
}

TEST(EulerAngles, AreAboveMinusHalfATurn) {
  for (const char* const axes : kSequences) {
    const EulerSequence sequence(axes);
    for (int i = -2; i <= 2; ++i) {
      for (int j = -2; j <= 2; ++j) {
        for (int k = -2; k <= 2; ++k) {
          const Eigen::Vector3d angles =
              sequence.angles(sequence.rotation(90 * kDegree * Eigen::Vector3d(i, j, k)));
          EXPECT_GT(angles.minCoeff(), -M_PI);
          EXPECT_LE(angles.maxCoeff(), M_PI);
        }
      }
    }
  }
}

TEST(EulerAngles, RefuseAxesThatAreNoSequence) {
  for (const char* const axes : {"", "zy", "zzy", "zyy", "zyw", "zyxz"})
    EXPECT_THROW(EulerSequence{axes}, scan_cell_common::InvalidParameter) << axes;
}
