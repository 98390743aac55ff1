// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/robot_model.h"

#include <fmt/format.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <limits>
#include <vector>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace c4g_driver {
namespace {

using scan_cell_common::InvalidParameter;

constexpr const char* kAxis = "";  // name of a segment that is no link but ends on a joint's axis

[[noreturn]] void refuse(const std::string& what, const std::string& cure) {
  throw InvalidParameter("robot description", what, cure);
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

KDL::Frame to_kdl(const urdf::Pose& pose) {
  const urdf::Rotation& turn = pose.rotation;
  return {KDL::Rotation::Quaternion(turn.x, turn.y, turn.z, turn.w),
          KDL::Vector(pose.position.x, pose.position.y, pose.position.z)};
}

/// Rotation from a frame whose z axis is the joint's axis to the joint's own frame.
KDL::Rotation turn_of_axis(const urdf::Vector3& axis) {
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d(axis.x, axis.y, axis.z),
                                                       Eigen::Vector3d::UnitZ());
  return KDL::Rotation::Quaternion(turn.x(), turn.y(), turn.z(), turn.w());
}

/// A URDF joint turns about or slides along an axis at the origin of the link that it moves. KDL's
/// joint about an arbitrary axis is not used: it caches its last angle, which is not thread-safe.
void add(KDL::Chain& chain, const urdf::Joint& joint) {
  const KDL::Frame origin = to_kdl(joint.parent_to_joint_origin_transform);
  const bool turns = joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
  const bool slides = joint.type == urdf::Joint::PRISMATIC;
  if (!turns && !slides) {
    chain.addSegment(
        KDL::Segment(joint.child_link_name, KDL::Joint(joint.name, KDL::Joint::None), origin));
    return;
  }
  const KDL::Frame from_axis(turn_of_axis(joint.axis));
  const auto type = turns ? KDL::Joint::RotZ : KDL::Joint::TransZ;
  chain.addSegment(KDL::Segment(kAxis, KDL::Joint(KDL::Joint::None), origin * from_axis.Inverse()));
  chain.addSegment(KDL::Segment(joint.child_link_name, KDL::Joint(joint.name, type), from_axis));
}

KDL::Chain chain_of(const urdf::ModelInterface& model, const std::string& base,
                    const std::string& flange) {
  std::vector<urdf::JointConstSharedPtr> joints;  // from the flange back
  urdf::LinkConstSharedPtr link = model.getLink(flange);
  for (; link && link->name != base; link = link->getParent())
    if (link->parent_joint) joints.push_back(link->parent_joint);
  if (!link) {
    refuse("no chain from '" + base + "' to '" + flange + "'",
           "set base_frame and flange_link to links of one chain in the URDF, base_frame first");
  }
  KDL::Chain chain;
  for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint)
    add(chain, **joint);
  if (chain.getNrOfJoints() != 6) {
    refuse(fmt::format("{} moving joints from '{}' to '{}'", chain.getNrOfJoints(), base, flange),
           "give an arm with six");
  }
  return chain;
}

}  // namespace

RobotModel::RobotModel(const std::string& urdf, const std::string& base,
                       const std::string& flange) {
  const auto model = urdf::parseURDF(urdf);
  if (!model) {
    refuse("'" + scan_cell_common::excerpt(urdf) + "'", "give a URDF that check_urdf accepts");
  }
  chain_ = chain_of(*model, base, flange);
  std::size_t i = 0;
  for (const KDL::Segment& segment : chain_.segments) {
    if (segment.getName() == kAxis) continue;
    link_names_.push_back(segment.getName());
    moving_.push_back(segment.getJoint().getType() != KDL::Joint::None);
    if (!moving_.back()) continue;
    names_[i] = segment.getJoint().getName();
    const auto joint = model->getJoint(names_[i]);
    const bool endless = joint->type == urdf::Joint::CONTINUOUS;
    if (joint->type != urdf::Joint::REVOLUTE && !endless)
      refuse(names_[i] + " does not turn", "give an arm with six revolute joints");
    if (!joint->limits || !(joint->limits->velocity > 0) ||
        (!endless && !(joint->limits->lower < joint->limits->upper))) {
      refuse(names_[i] + " has no range or no speed", "give its limit: lower, upper and velocity");
    }
    const auto k = static_cast<Eigen::Index>(i);
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    lower_[k] = endless ? -kEndless : joint->limits->lower;
    upper_[k] = endless ? kEndless : joint->limits->upper;
    speed_[k] = joint->limits->velocity;
    ++i;
  }
}

Eigen::Isometry3d RobotModel::flange_at(const Joints& joints) const {
  KDL::ChainFkSolverPos_recursive solver(chain_);
  KDL::Frame frame;
  solver.JntToCart(to_kdl(joints), frame);
  return from_kdl(frame);
}

std::vector<Eigen::Isometry3d> RobotModel::links_at(const Joints& joints) const {
  std::vector<KDL::Frame> frames(chain_.getNrOfSegments());
  KDL::ChainFkSolverPos_recursive solver(chain_);
  solver.JntToCart(to_kdl(joints), frames);
  std::vector<Eigen::Isometry3d> poses;
  poses.reserve(link_names_.size() + 1);
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (chain_.segments[i].getName() != kAxis) poses.push_back(from_kdl(frames[i]));
  return poses;
}

Eigen::Vector3d RobotModel::next_origin(std::size_t link) const {
  // joints turn about their link's origin, so any angle gives the same result as 0
  const std::vector<Eigen::Isometry3d> links = links_at(Joints::Zero());
  std::size_t next = link + 1;
  while (next < links.size() && !moving_[next])
    ++next;
  return links[link].inverse() * links[std::min(next, links.size() - 1)].translation();
}

RobotModel::Jacobian RobotModel::jacobian_at(const Joints& joints) const {
  KDL::ChainJntToJacSolver solver(chain_);
  KDL::Jacobian jacobian(6);
  solver.JntToJac(to_kdl(joints), jacobian);
  return jacobian.data;
}

Eigen::Matrix<double, 6, 1> twist(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
  Eigen::Matrix<double, 6, 1> result;
  result << to.translation() - from.translation(), turn.angle() * turn.axis();
  return result;
}

KDL::JntArray to_kdl(const Joints& joints) {
  KDL::JntArray result(6);
  result.data = joints;
  return result;
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

}  // namespace c4g_driver
