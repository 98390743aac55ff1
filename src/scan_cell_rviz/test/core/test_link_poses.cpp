// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "preview/link_poses.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_cell_rviz {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr const char* kArm = R"(<robot name="arm">
  <link name="floor"/><link name="base"/><link name="upper"/><link name="bracket"/><link name="fore"/>
  <joint name="stand" type="fixed"><parent link="floor"/><child link="base"/>
    <origin xyz="0 0 0.5" rpy="0 0 0"/></joint>
  <joint name="J1" type="revolute"><parent link="base"/><child link="upper"/>
    <origin xyz="0.1 0 0.2" rpy="0 0 0"/><axis xyz="0 0 -1"/>
    <limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
  <joint name="mount" type="fixed"><parent link="upper"/><child link="bracket"/>
    <origin xyz="0 0.05 0" rpy="0 0 0"/></joint>
  <joint name="J2" type="revolute"><parent link="upper"/><child link="fore"/>
    <origin xyz="0.3 0 0" rpy="0 0 0"/><axis xyz="0 1 0"/>
    <limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
</robot>)";

TEST(LinkPoses, AreThoseOfTheJointsAlsoBesideTheChain) {
  const auto poses = LinkPoses(kArm).at("base", {{"J1", 0.3}, {"J2", -0.7}});
  const Isometry3d upper = Translation3d(0.1, 0, 0.2) * AngleAxisd(-0.3, Vector3d::UnitZ());
  EXPECT_TRUE(poses.at("upper").isApprox(upper, 1e-12));
  EXPECT_TRUE(poses.at("bracket").isApprox(upper * Translation3d(0, 0.05, 0), 1e-12));
  EXPECT_TRUE(poses.at("fore").isApprox(
      upper * Translation3d(0.3, 0, 0) * AngleAxisd(-0.7, Vector3d::UnitY()), 1e-12));
  EXPECT_TRUE(poses.at("floor").isApprox(Isometry3d(Translation3d(0, 0, -0.5)), 1e-12));
}

TEST(LinkPoses, RefuseABaseThatIsNoLinkAndAJointThatIsNone) {
  EXPECT_THROW(LinkPoses(kArm).at("world", {}), scan_cell_common::UnusableInput);
  EXPECT_THROW(LinkPoses(kArm).at("base", {{"joint_1", 0}}), scan_cell_common::UnusableInput);
}

TEST(LinkPoses, RefuseWhatIsNoUrdf) {
  EXPECT_THROW(LinkPoses("<robot>"), scan_cell_common::UnusableInput);
}

}  // namespace
}  // namespace scan_cell_rviz
