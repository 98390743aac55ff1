// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <urdf/model.h>

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl_parser/kdl_parser.hpp>
#include <random>

#include "robot/closed_form.h"

namespace {

class Urdf : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(model_.initFile(URDF_FILE));
    KDL::Tree tree;
    ASSERT_TRUE(kdl_parser::treeFromUrdfModel(model_, tree));
    ASSERT_TRUE(tree.getChain("base_link", "flange", chain_));
    ASSERT_EQ(chain_.getNrOfJoints(), 6u);
  }

  Eigen::Isometry3d link_pose(const std::string& root, const std::string& tip) const {
    KDL::Tree tree;
    KDL::Chain chain;
    kdl_parser::treeFromUrdfModel(model_, tree);
    tree.getChain(root, tip, chain);
    return solve(chain, Eigen::VectorXd::Zero(chain.getNrOfJoints()));
  }

  static Eigen::Isometry3d solve(const KDL::Chain& chain, const Eigen::VectorXd& joints) {
    KDL::ChainFkSolverPos_recursive solver(chain);
    KDL::JntArray array(static_cast<unsigned>(joints.size()));
    array.data = joints;
    KDL::Frame frame;
    solver.JntToCart(array, frame);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (int row = 0; row < 3; ++row) {
      pose.translation()[row] = frame.p[row];
      for (int column = 0; column < 3; ++column)
        pose.linear()(row, column) = frame.M(row, column);
    }
    return pose;
  }

  urdf::Model model_;
  KDL::Chain chain_;
};

}  // namespace

TEST_F(Urdf, PutsTheFlangeWhereTheDataSheetPutsIt) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (int i = 0; i < 200; ++i) {
    Eigen::Matrix<double, 6, 1> joints;
    for (double& joint : joints)
      joint = angle(random);
    EXPECT_TRUE(solve(chain_, joints).isApprox(flange_by_denavit_hartenberg(joints), 1e-12));
  }
}

TEST_F(Urdf, LeavesTool0ToTheDriver) {
  EXPECT_FALSE(model_.getLink("tool0"));
  EXPECT_EQ(model_.getRoot()->name, "base_link");
}

TEST_F(Urdf, HoldsLasersHalfAMetreApartThatCrossInFrontOfTheCamera) {
  const Eigen::Isometry3d camera = link_pose("flange", "camera_body");
  EXPECT_TRUE(camera.translation().isApprox(Eigen::Vector3d(0, 0, 0.085)));
  const Eigen::Isometry3d left = camera.inverse() * link_pose("flange", "laser_housing_0");
  const Eigen::Isometry3d right = camera.inverse() * link_pose("flange", "laser_housing_1");
  EXPECT_NEAR((left.translation() - right.translation()).norm(), 0.5, 1e-12);
  for (const Eigen::Isometry3d& laser : {left, right}) {
    const Eigen::Vector3d beam = laser.linear().col(2);
    const double range = -laser.translation().x() / beam.x();
    EXPECT_NEAR((laser.translation() + range * beam).z(), 0.5, 0.002);
  }
}
