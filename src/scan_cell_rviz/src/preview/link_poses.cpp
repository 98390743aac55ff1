// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "preview/link_poses.h"

#include <algorithm>
#include <kdl_parser/kdl_parser.hpp>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_rviz {
namespace {

using Poses = std::map<std::string, KDL::Frame>;

void add(Poses& poses, const KDL::SegmentMap::const_iterator& link, const KDL::Frame& parent,
         const std::map<std::string, double>& joints) {
  const KDL::Segment& segment = GetTreeElementSegment(link->second);
  const auto angle = joints.find(segment.getJoint().getName());
  const KDL::Frame pose = parent * segment.pose(angle == joints.end() ? 0 : angle->second);
  poses[link->first] = pose;
  for (const auto& child : GetTreeElementChildren(link->second))
    add(poses, child, pose, joints);
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

LinkPoses::LinkPoses(const std::string& urdf) {
  if (!kdl_parser::treeFromString(urdf, tree_))
    throw scan_cell_common::UnusableInput("robot_description", "not a URDF",
                                          "give a URDF that check_urdf accepts");
}

std::map<std::string, Eigen::Isometry3d> LinkPoses::at(
    const std::string& base, const std::map<std::string, double>& joints) const {
  for (const auto& [name, angle] : joints) {
    const auto& links = tree_.getSegments();
    const bool known = std::any_of(links.begin(), links.end(), [&name = name](const auto& link) {
      return GetTreeElementSegment(link.second).getJoint().getName() == name;
    });
    if (!known)
      throw scan_cell_common::UnusableInput("joint " + name, "not in robot_description",
                                            "give the URDF of the robot that the driver has");
  }
  Poses found;
  add(found, tree_.getRootSegment(), KDL::Frame::Identity(), joints);
  std::map<std::string, Eigen::Isometry3d> poses;
  const auto origin = found.find(base);
  if (origin == found.end())
    throw scan_cell_common::UnusableInput("frame " + base, "not a link of robot_description",
                                          "give the URDF of the robot that the driver has");
  const KDL::Frame to_base = origin->second.Inverse();
  for (const auto& [name, pose] : found)
    poses[name] = from_kdl(to_base * pose);
  return poses;
}

}  // namespace scan_cell_rviz
