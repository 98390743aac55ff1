// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/controller/kinematics.h"

#include <cmath>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <sstream>

namespace scan_cell_sim {
namespace {

constexpr double kDegree = M_PI / 180;

// Made from the data sheet's lengths and not from the URDF, so that an error in one of them shows.
KDL::Chain make_chain() {
  using KDL::Frame;
  using KDL::Joint;
  using KDL::Rotation;
  using KDL::Segment;
  using KDL::Vector;
  constexpr double kD1 = 0.450, kA1 = 0.150, kA2 = 0.590, kA3 = 0.130, kD4 = 0.64707, kD6 = 0.095;
  const Rotation forearm_up = Rotation::RotY(-M_PI / 2);
  // z of the flange along the forearm; with the wrist straight and the forearm level, x is up
  const Rotation flange(Vector(0, 0, 1), Vector(0, -1, 0), Vector(1, 0, 0));
  const auto axis = [](const Vector& direction) {
    return Joint(Vector::Zero(), direction, Joint::RotAxis);
  };
  KDL::Chain chain;
  chain.addSegment(Segment(axis({0, 0, -1}), Frame(Vector(kA1, 0, kD1))));
  chain.addSegment(Segment(axis({0, 1, 0}), Frame(forearm_up, Vector(0, 0, kA2))));
  chain.addSegment(Segment(axis({0, -1, 0}), Frame(Vector(kD4, 0, kA3))));
  chain.addSegment(Segment(axis({-1, 0, 0})));
  chain.addSegment(Segment(axis({0, 1, 0})));
  chain.addSegment(Segment(axis({-1, 0, 0}), Frame(flange, Vector(kD6, 0, 0))));
  return chain;
}

const KDL::Chain& chain() {
  static const KDL::Chain made = make_chain();
  return made;
}

JointLimits make_limits() {
  JointLimits limits;
  limits.lower << -170, -85, -170, -210, -130, -2700;
  limits.upper << 170, 155, 0, 210, 130, 2700;
  limits.speed << 140, 160, 170, 450, 375, 550;
  limits.lower *= kDegree;
  limits.upper *= kDegree;
  limits.speed *= kDegree;
  limits.acceleration = limits.speed * 4;
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

KDL::Frame to_kdl(const Eigen::Isometry3d& pose) {
  KDL::Frame frame;
  for (int row = 0; row < 3; ++row) {
    frame.p[row] = pose.translation()[row];
    for (int column = 0; column < 3; ++column)
      frame.M(row, column) = pose.linear()(row, column);
  }
  return frame;
}

/// Small motion from one pose to the other: translation [m], then rotation vector [rad], in
/// base_link.
Eigen::Matrix<double, 6, 1> twist(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
  Eigen::Matrix<double, 6, 1> result;
  result << to.translation() - from.translation(), turn.angle() * turn.axis();
  return result;
}

Eigen::Matrix<double, 6, 6> jacobian(const Joints& joints) {
  KDL::ChainJntToJacSolver solver(chain());
  KDL::Jacobian result(6);
  solver.JntToJac(to_kdl(joints), result);
  return result.data;
}

}  // namespace

const JointLimits& joint_limits() {
  static const JointLimits limits = make_limits();
  return limits;
}

std::string outside_limits(const Joints& joints) {
  constexpr double kRounding = 1e-6;
  const JointLimits& limits = joint_limits();
  for (int i = 0; i < 6; ++i) {
    if (joints[i] >= limits.lower[i] - kRounding && joints[i] <= limits.upper[i] + kRounding)
      continue;
    std::ostringstream text;
    text << "J" << i + 1 << " " << joints[i] / kDegree << " deg is outside "
         << limits.lower[i] / kDegree << " .. " << limits.upper[i] / kDegree;
    return text.str();
  }
  return "";
}

Eigen::Isometry3d flange_of(const Joints& joints) {
  KDL::ChainFkSolverPos_recursive solver(chain());
  KDL::Frame frame;
  solver.JntToCart(to_kdl(joints), frame);
  return from_kdl(frame);
}

std::optional<Joints> joints_of(const Eigen::Isometry3d& flange, const Joints& near) {
  constexpr double kPrecision = 1e-9;  // [m] and [rad]
  constexpr double kNear = 1e-5;       // KDL takes smaller rotations for none: Newton does the rest
  constexpr int kIterations = 100;
  constexpr int kNewtonSteps = 4;
  const Eigen::Matrix<double, 6, 1> weights = Eigen::Matrix<double, 6, 1>::Ones();
  KDL::ChainIkSolverPos_LMA solver(chain(), weights, kNear, kIterations);
  KDL::JntArray found(6);
  solver.CartToJnt(to_kdl(near), to_kdl(flange), found);
  Joints joints = found.data;
  for (int step = 0; step <= kNewtonSteps && joints.allFinite(); ++step) {
    const Joints error = twist(flange_of(joints), flange);
    if (error.head<3>().norm() < kPrecision && error.tail<3>().norm() < kPrecision) return joints;
    joints += jacobian(joints).fullPivLu().solve(error);
  }
  return std::nullopt;
}

}  // namespace scan_cell_sim
