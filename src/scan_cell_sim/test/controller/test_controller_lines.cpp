// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Which poses the emulated arm reaches, and which lines it follows.
#include <random>

#include "controller/arm_truth.h"
#include "scan_cell_sim/controller/path.h"

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using scan_cell_sim::ControllerErrorCode;
using scan_cell_sim::flange_of;
using scan_cell_sim::Joints;
using scan_cell_sim::plan_line;

namespace {

/// Determinant of the Jacobian, by differences of the product of exponentials.
double determinant(const Joints& joints) {
  constexpr double kStep = 1e-6;
  Eigen::Matrix<double, 6, 6> jacobian;
  for (int axis = 0; axis < 6; ++axis) {
    const Joints step = kStep * Joints::Unit(axis);
    const Isometry3d before = product_of_exponentials(joints - step);
    const Isometry3d after = product_of_exponentials(joints + step);
    const AngleAxisd turn(after.linear() * before.linear().transpose());
    jacobian.col(axis) << after.translation() - before.translation(), turn.angle() * turn.axis();
  }
  return (jacobian / (2 * kStep)).determinant();
}

Joints any_posture(std::mt19937& random) {
  const auto& limits = scan_cell_sim::joint_limits();
  Joints joints;
  for (int axis = 0; axis < 6; ++axis)
    joints[axis] =
        std::uniform_real_distribution<double>(limits.lower[axis], limits.upper[axis])(random);
  return joints;
}

ControllerErrorCode refused_line(const Joints& from, const Joints& to) {
  return refusal([&] { plan_line(from, product_of_exponentials(to), {}); });
}

}  // namespace

TEST(Postures, AreFoundForEveryPoseThatTheArmTakes) {
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    const Joints joints = any_posture(random);
    const Isometry3d flange = product_of_exponentials(joints);
    double nearest = 1;
    for (const Joints& found : scan_cell_sim::postures_of(flange, joints)) {
      expect_same(product_of_exponentials(found), flange, 1e-9);
      nearest = std::min(nearest, (found - joints).norm());
    }
    EXPECT_LT(nearest, 1e-6) << joints.transpose() / kDegree;
    const Joints reached = scan_cell_sim::reach(flange, degrees(0, 0, -90, 0, 90, 0));
    expect_same(product_of_exponentials(reached), flange, 1e-9);
    EXPECT_EQ(scan_cell_sim::outside_limits(reached), "");
  }
}

TEST(Postures, AreNoneBeyondTheStretchedArm) {
  // straight up: d1 + a2 + the forearm to the wrist + d6, in line above axis 2
  const double top = 0.450 + 0.590 + std::hypot(0.130, 0.64707) + 0.095;
  Isometry3d flange = Isometry3d::Identity();
  flange.translation() << 0.150, 0, top - 1e-6;
  EXPECT_FALSE(scan_cell_sim::postures_of(flange, Joints::Zero()).empty());
  flange.translation().z() = top + 1e-6;
  EXPECT_TRUE(scan_cell_sim::postures_of(flange, Joints::Zero()).empty());
}

TEST(SingularPostures, AreWhereTheJacobianHasNoInverse) {
  std::mt19937 random(7);
  for (int i = 0; i < 100; ++i) {
    const Joints joints = any_posture(random);
    const auto distance = scan_cell_sim::distance_to_singular(joints);
    // of the arm a2 times the forearm times the sine of its bend, of the wrist the sine of J5
    const double expected = 0.590 * std::hypot(0.130, 0.64707) * std::sin(distance.elbow) *
                            distance.shoulder * std::sin(distance.wrist);
    EXPECT_NEAR(std::abs(determinant(joints)), std::abs(expected), 1e-7);
  }
  const double stretched = -std::atan2(0.130, 0.64707) / kDegree;
  for (const Joints& singular :
       {degrees(10, 20, -80, 30, 0, 50), degrees(0, 30, stretched, 0, 50, 0)})
    EXPECT_NEAR(determinant(singular), 0, 1e-9);
}

TEST(Line, IsRefusedStraightThroughTheStraightWrist) {
  EXPECT_EQ(refused_line(degrees(0, 0, -90, 0, 45, 0), degrees(0, 0, -90, 0, -45, 0)),
            ControllerErrorCode::kSingular);
  EXPECT_EQ(refused_line(degrees(0, 0, -90, 0, 20, 0), degrees(0, 0, -90, 0, -20, 0)),
            ControllerErrorCode::kSingular);
}

TEST(Line, IsRefusedAtASingularEnd) {
  const Joints bent = degrees(0, 0, -90, 0, 45, 0);
  const Joints straight = degrees(0, 0, -90, 0, 0, 0);
  EXPECT_EQ(refused_line(bent, straight), ControllerErrorCode::kSingular);
  EXPECT_EQ(refused_line(straight, bent), ControllerErrorCode::kSingular);
}

TEST(Line, IsRefusedOverTheAxisOfTheBase) {
  // leaning back by 40 degrees the wrist's centre is in front of axis 1, and then behind it
  EXPECT_EQ(refused_line(degrees(0, -40, -80, 0, 60, 0), degrees(0, -40, -60, 0, 60, 0)),
            ControllerErrorCode::kSingular);
}

TEST(Line, IsRefusedWhereTheWristWouldTurnOver) {
  // the flange's axis swings past the forearm's at one degree: J4 would have to turn half around
  const Joints from = degrees(0, 0, -90, 3, 20, 0);
  const Joints past = degrees(0, 0, -90, -3, -20, 0);
  EXPECT_EQ(refused_line(from, past), ControllerErrorCode::kSingular);
}

TEST(Line, ThatLeavesTheReachIsRefusedAsSuchHoweverFarItGoes) {
  const Joints from = degrees(0, 0, -90, 0, 90, 0);
  for (const double x : {1.6, 100.0, 1e300}) {
    EXPECT_EQ(refusal([&] { plan_line(from, looking_down(x, 0, 0.6), {}); }),
              ControllerErrorCode::kOutOfReach);
  }
}

TEST(Line, GoesOnItsSideOfTheStraightWrist) {
  const Joints from = degrees(0, 0, -90, 0, 45, 0);
  const Joints to = degrees(0, 0, -90, 0, 2, 0);
  const auto plan = plan_line(from, product_of_exponentials(to), {});
  expect_same(product_of_exponentials(plan.path->joints(1)), product_of_exponentials(to), 1e-9);
  EXPECT_LT((plan.path->joints(1) - to).norm(), 1e-6);
}

TEST(Line, TurnsItsAnglesEachAtItsOwnConstantRateWhereThatIsAskedFor) {
  scan_cell_sim::LineSettings euler;
  euler.euler = true;
  euler.rotational_speed = 60 * kDegree;
  const Joints from = degrees(0, 0, -90, 0, 90, 0);  // A, E, R = 0, 180, 180
  Isometry3d to = flange_of(from);
  const auto angles = [](double a, double e, double r) {
    return AngleAxisd(a * kDegree, Vector3d::UnitZ()) * AngleAxisd(e * kDegree, Vector3d::UnitY()) *
           AngleAxisd(r * kDegree, Vector3d::UnitZ());
  };
  to.linear() = angles(20, 150, -170).toRotationMatrix();
  const auto plan = plan_line(from, to, euler);
  Isometry3d half = to;
  half.linear() = angles(10, 165, -175).toRotationMatrix();  // R by the shorter way round
  expect_same(plan.path->flange(0.5), half, 1e-9);
  EXPECT_NEAR(plan.speed, 60.0 / 30, 1e-9) << "E turns the most, by 30 degrees";
}
