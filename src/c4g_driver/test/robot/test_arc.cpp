// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The driver's arc, compared with circles in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "degree.h"
#include "robot/motion_check_test.h"
#include "robot/paths/arc.h"

using c4g_driver::Arc;
using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

/// A pose that turns with its place on a circle about an upright axis.
Isometry3d round_the_part(double angle) {
  const Eigen::Translation3d centre(0.8, 0.1, 0.5);
  return centre * AngleAxisd(angle * kDegree, Vector3d::UnitZ()) * looking_down(0.2, 0, 0);
}

double off(const Isometry3d& pose, const Isometry3d& expected) {
  return c4g_driver::twist(pose, expected).norm();
}

std::string refusal(const Isometry3d& from, const Isometry3d& via, const Isometry3d& to) {
  try {
    Arc(from, via, to);
  } catch (const scan_cell_common::Refused& refused) {
    return refused.what();
  }
  return "";
}

}  // namespace

TEST(Arc, GoesRoundAsViaSaysTheLongWayToo) {
  struct Case {
    double via, to;
  };
  for (const Case& turn : {Case{45, 90}, Case{10, 90}, Case{-170, -270}, Case{130, 300}}) {
    const Arc arc(round_the_part(0), round_the_part(turn.via), round_the_part(turn.to));
    for (double way = 0; way <= 1; way += 1.0 / 32)
      EXPECT_LT(off(arc.at(way), round_the_part(way * turn.to)), 1e-12) << turn.to << " " << way;
    const auto stretches = arc.stretches();
    ASSERT_EQ(stretches.size(), 2u);
    EXPECT_NEAR(stretches[0].end, turn.via / turn.to, 1e-12);
    EXPECT_NEAR(stretches[0].length + stretches[1].length, 0.2 * std::abs(turn.to) * kDegree,
                1e-12);
    EXPECT_NEAR(stretches[0].angle, std::abs(turn.via) * kDegree, 1e-9);
    EXPECT_NEAR(stretches[1].angle, std::abs(turn.to - turn.via) * kDegree, 1e-9);
  }
}

TEST(Arc, HasTheOrientationOfViaAtViaAndTurnsAboutOneAxisOnEachSide) {
  Isometry3d via = round_the_part(60), to = round_the_part(180);
  via.rotate(AngleAxisd(0.4, Vector3d::UnitX()));
  to.rotate(AngleAxisd(-0.5, Vector3d::UnitY()));
  const Arc arc(round_the_part(0), via, to);
  EXPECT_LT(off(arc.at(1.0 / 3), via), 1e-12);
  EXPECT_LT(off(arc.at(1), to), 1e-12);
  const AngleAxisd half(round_the_part(0).linear().transpose() * arc.at(1.0 / 6).linear());
  const AngleAxisd whole(round_the_part(0).linear().transpose() * via.linear());
  EXPECT_NEAR(half.angle(), whole.angle() / 2, 1e-12);
  EXPECT_TRUE(half.axis().isApprox(whole.axis(), 1e-9));
}

TEST(Arc, LiesOnTheCircleOfAnyThreePlaces) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> some(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d centre(some(random), some(random), some(random));
    const double radius = std::pow(10, some(random) - 1);
    const Eigen::Quaterniond plane = Eigen::Quaterniond::UnitRandom();
    const auto place = [&](double angle) {
      Isometry3d pose = looking_down(0, 0, 0);
      pose.translation() =
          centre + plane * (radius * Vector3d(std::cos(angle), std::sin(angle), 0));
      return pose;
    };
    const double end = 3.6 + 2.4 * some(random), via = end * (0.5 + 0.3 * some(random));
    const Arc arc(place(0), place(via), place(end));
    for (const double way : {0.0, 0.1, 0.4, 0.7, 1.0})
      EXPECT_LT(off(arc.at(way), place(way * end)), 1e-9) << via << " " << end << " " << radius;
  }
}

TEST(Arc, IsNoneByNameWhereThreePlacesHaveNoCircle) {
  const Isometry3d from = looking_down(0.8, 0, 0.6), to = looking_down(0.8, 0.1, 0.6);
  const Isometry3d via = looking_down(0.85, 0.05, 0.6);
  EXPECT_EQ(refusal(from, via, to), "");
  EXPECT_EQ(refusal(from, from, to).find("via: 0 m from where the robot stands; give three"), 0u);
  EXPECT_EQ(refusal(from, via, from).find("target: 0 m from where the robot stands; give"), 0u);
  EXPECT_EQ(refusal(from, to, to).find("via: 0 m from the target; give three"), 0u);
  EXPECT_NE(refusal(from, looking_down(0.8, 0.0009, 0.6), to), "");
  for (const double y : {0.05, -0.05, 0.15}) {
    const std::string said = refusal(from, looking_down(0.8 + 0.5e-4, y, 0.6), to);
    EXPECT_EQ(said.find("via: only "), 0u) << y << said;
    EXPECT_NE(said.find(" m off the line from start to target; give three"), std::string::npos)
        << said;
    EXPECT_NE(said.find("or go along a line"), std::string::npos) << said;
  }
  EXPECT_EQ(refusal(from, looking_down(0.8 + 1.1e-4, 0.05, 0.6), to), "");
}

TEST(Arc, IsNoneByNameWhereItIsOpenWhichWayItTurns) {
  const Isometry3d from = looking_down(0.8, 0, 0.6), to = looking_down(0.8, 0.1, 0.6);
  const Isometry3d via = looking_down(0.85, 0.05, 0.6);
  const AngleAxisd half(M_PI, Vector3d::UnitZ()), nearly(179.5 * kDegree, Vector3d::UnitZ());
  EXPECT_EQ(refusal(from, via * half, to).find("via orientation: 3.14159 rad from"), 0u);
  EXPECT_EQ(refusal(from, via, to * half).find("target orientation: 3.14159 rad from"), 0u);
  EXPECT_EQ(refusal(from, via * nearly, to), "");
}
