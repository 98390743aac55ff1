// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/controller/kinematics.h"

#include <fmt/format.h>

#include <cmath>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>

#include "controller/arm/arm.h"
#include "scan_cell_common/pose/units.h"

namespace scan_cell_sim {
namespace {

using scan_cell_common::kDegree;

KDL::Chain make_chain() {
  using KDL::Frame;
  using KDL::Joint;
  using KDL::Rotation;
  using KDL::Segment;
  using KDL::Vector;
  const Rotation forearm_up = Rotation::RotY(-M_PI / 2);
  const Eigen::Matrix3d turn = flange_turn();
  const auto column = [&turn](int i) { return Vector(turn(0, i), turn(1, i), turn(2, i)); };
  const Rotation flange(column(0), column(1), column(2));
  // Not Joint::RotAxis: it stores its last angle, so threads that share one corrupt each other's.
  const Joint minus_x(Joint::RotX, -1), y(Joint::RotY), minus_y(Joint::RotY, -1),
      minus_z(Joint::RotZ, -1);
  KDL::Chain chain;
  chain.addSegment(Segment(minus_z, Frame(Vector(kA1, 0, kD1))));
  chain.addSegment(Segment(y, Frame(forearm_up, Vector(0, 0, kA2))));
  chain.addSegment(Segment(minus_y, Frame(Vector(kD4, 0, kA3))));
  chain.addSegment(Segment(minus_x));
  chain.addSegment(Segment(y));
  chain.addSegment(Segment(minus_x, Frame(flange, Vector(kD6, 0, 0))));
  return chain;
}

const KDL::Chain& chain() {
  static const KDL::Chain made = make_chain();
  return made;
}

JointLimits make_limits() {
  JointLimits limits;
  // [deg], [deg/s] data sheet
  limits.lower << -170, -85, -170, -210, -130, -2700;
  limits.upper << 170, 155, 0, 210, 130, 2700;
  limits.speed << 140, 160, 170, 450, 375, 550;
  limits.lower *= kDegree;
  limits.upper *= kDegree;
  limits.speed *= kDegree;
  constexpr double kSpinUp = 4;  // [1/s] full speed in a quarter of a second; chosen
  limits.acceleration = limits.speed * kSpinUp;
  return limits;
}

KDL::JntArray to_kdl(const Joints& joints) {
  KDL::JntArray result(6);
  result.data = joints;
  return result;
}

Eigen::Isometry3d from_kdl(const KDL::Frame& frame) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    pose.translation()[row] = frame.p[row];
    for (int column = 0; column < 3; ++column)
      pose.linear()(row, column) = frame.M(row, column);
  }
  return pose;
}

}  // namespace

const JointLimits& joint_limits() {
  static const JointLimits limits = make_limits();
  return limits;
}

std::string outside_limits(const Joints& joints) {
  constexpr double kRounding = 1e-6;  // [rad] chosen
  const JointLimits& limits = joint_limits();
  for (int i = 0; i < 6; ++i) {
    if (joints[i] >= limits.lower[i] - kRounding && joints[i] <= limits.upper[i] + kRounding)
      continue;
    return fmt::format("J{} {:g} deg is outside {:g} .. {:g}", i + 1, joints[i] / kDegree,
                       limits.lower[i] / kDegree, limits.upper[i] / kDegree);
  }
  return "";
}

Eigen::Isometry3d flange_of(const Joints& joints) {
  KDL::ChainFkSolverPos_recursive solver(chain());
  KDL::Frame frame;
  solver.JntToCart(to_kdl(joints), frame);
  return from_kdl(frame);
}

SingularPostures distance_to_singular(const Joints& joints) {
  const double bend = joints[2] + kForearmAngle;
  const double reached = kA1 + kA2 * std::sin(joints[1]) + kForearm * std::sin(joints[1] - bend);
  return {joints[4], bend, reached};
}

}  // namespace scan_cell_sim
