// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_check/spin/spin_arm.h"

#include <limits>

#include "c4g_driver/collision_scene.h"
#include "robot/inverse_kinematics.h"
#include "robot/path_check.h"

namespace c4g_driver {
namespace {

constexpr double kNear = 0.3;    // [rad] from an end of a range; chosen
constexpr double kWeight = 0.3;  // of the strain at an end: as a joint at half its speed; chosen

}  // namespace

SpinArm::SpinArm(const ToolCheckSubject& subject)
    : subject_(subject), tip_to_flange_(subject.motion.flange_to_tip.inverse()) {
  lower_ = subject.limits.joint_lower.array() + subject.parameters.joint_margin;
  upper_ = subject.limits.joint_upper.array() - subject.parameters.joint_margin;
}

std::optional<Joints> SpinArm::joints(const SpinNode& node, double turn, const Joints& near) const {
  return step_to(subject_.robot, spun(node.tip, turn) * tip_to_flange_, near);
}

Joints SpinArm::rate(const SpinNode& node, double turn, const Joints& joints) const {
  const Eigen::Isometry3d flange = spun(node.tip, turn) * tip_to_flange_;
  const Eigen::Vector3d axis = node.tip.linear().col(2);
  Eigen::Matrix<double, 6, 1> rate;
  rate << axis.cross(flange.translation() - node.tip.translation()), axis;
  return subject_.robot.jacobian_at(joints).partialPivLu().solve(rate);
}

bool SpinArm::possible(const Joints& joints) const {
  if (excess(joints, lower_, upper_) > 0) return false;
  const Eigen::Vector3d place = subject_.robot.flange_at(joints).translation();
  if ((place.array() < subject_.limits.workspace_min.array()).any()) return false;
  if ((place.array() > subject_.limits.workspace_max.array()).any()) return false;
  if (!singular_joints(subject_.robot.jacobian_at(joints)).empty()) return false;
  return subject_.scene == nullptr ||
         subject_.scene->collisions(joints, subject_.motion.flange_to_tip).empty();
}

double SpinArm::strain(const Joints& joints) const {
  const Joints left = (joints - lower_).cwiseMin(upper_ - joints);
  return kWeight * ((kNear - left.array()).max(0) / kNear).square().sum();
}

std::pair<double, double> SpinArm::strain_slope(const Joints& joints, const Joints& rate) const {
  double slope = 0, curve = 0;
  for (int i = 0; i < 6; ++i) {
    const bool low = joints[i] - lower_[i] < upper_[i] - joints[i];
    const double near = kNear - (low ? joints[i] - lower_[i] : upper_[i] - joints[i]);
    if (near <= 0) continue;
    slope += 2 * kWeight / (kNear * kNear) * near * (low ? -rate[i] : rate[i]);
    curve += 2 * kWeight / (kNear * kNear) * rate[i] * rate[i];
  }
  return {slope, curve};
}

double SpinArm::cost(const Joints& from, const Joints& to, double seconds) const {
  constexpr double kSamePosture = 0.8;  // [rad] between nodes; chosen
  const Joints change = to - from;
  if (!(change.cwiseAbs().maxCoeff() < kSamePosture))
    return std::numeric_limits<double>::infinity();
  return change.cwiseQuotient(speed()).squaredNorm() / std::max(seconds, kLeastSeconds);
}

}  // namespace c4g_driver
