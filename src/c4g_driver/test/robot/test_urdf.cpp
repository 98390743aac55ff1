// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <stdio.h>
#include <urdf/model.h>

#include <array>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl_parser/kdl_parser.hpp>
#include <random>

#include "robot/closed_form.h"

namespace {

class Urdf : public testing::Test {
 protected:
  void SetUp() override { load(model_.initFile(URDF_FILE)); }

  void load(bool read) {
    ASSERT_TRUE(read);
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

  const urdf::Visual& visual(const std::string& link, std::size_t index) const {
    return *model_.getLink(link)->visual_array.at(index);
  }

  /// Edges [m] along x, y, z of a box.
  Eigen::Vector3d size(const std::string& link, std::size_t index) const {
    const auto& box = dynamic_cast<const urdf::Box&>(*visual(link, index).geometry);
    return {box.dim.x, box.dim.y, box.dim.z};
  }

  Eigen::Vector3d place(const std::string& link, std::size_t index) const {
    const urdf::Vector3& position = visual(link, index).origin.position;
    return {position.x, position.y, position.z};
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

/// Output of robot_description.py, with its errors.
std::string printed(const std::string& arguments, int& status) {
  const std::string command = "/usr/bin/python3 " BRACKET " " + arguments + " 2>&1";
  FILE* const pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> part{};
  while (const std::size_t size = fread(part.data(), 1, part.size(), pipe))
    text.append(part.data(), size);
  status = WEXITSTATUS(pclose(pipe));
  return text;
}

/// The model with a bracket set up by arguments.
class Bracket : public Urdf {
 protected:
  void set_up(const std::string& arguments) {
    int status = 0;
    const std::string text = printed(arguments, status);
    ASSERT_EQ(status, 0) << text;
    load(model_.initString(text));
  }
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

TEST_F(Bracket, IsThatOfTheFileWithoutArguments) {
  const Eigen::Isometry3d laser = link_pose("flange", "laser_housing_0");
  const Eigen::Vector3d clamp = place("bracket", 4), body = size("camera_body", 0);
  set_up("");
  EXPECT_TRUE(link_pose("flange", "laser_housing_0").isApprox(laser, 1e-12));
  set_up("laser_0_tilt=0.4735 laser_1_height=0.097 camera_body=generic");
  EXPECT_TRUE(link_pose("flange", "laser_housing_0").isApprox(laser, 1e-12));
  EXPECT_TRUE(place("bracket", 4).isApprox(clamp, 1e-12));
  EXPECT_TRUE(size("camera_body", 0).isApprox(body, 1e-12));
}

TEST_F(Bracket, HoldsEachLaserWhereItsArgumentsSay) {
  set_up("laser_0_half_distance=0.2 laser_0_height=0.12 laser_0_tilt=0.3 laser_1_tilt=-0.1");
  const Eigen::Isometry3d left = link_pose("flange", "laser_housing_0");
  EXPECT_TRUE(left.translation().isApprox(Eigen::Vector3d(-0.2, 0, 0.12), 1e-12));
  // Tilted to the camera's side: its light crosses the camera's axis at half distance / tan(tilt)
  const Eigen::Vector3d light = left.linear().col(2);
  EXPECT_TRUE(light.isApprox(Eigen::Vector3d(std::sin(0.3), 0, std::cos(0.3)), 1e-12));
  const Eigen::Isometry3d right = link_pose("flange", "laser_housing_1");
  EXPECT_TRUE(right.translation().isApprox(Eigen::Vector3d(0.25, 0, 0.097), 1e-12));
  EXPECT_TRUE(
      right.linear().col(2).isApprox(Eigen::Vector3d(std::sin(0.1), 0, std::cos(0.1)), 1e-9));
  // The clamp reaches from the profile (50 mm) to 31 mm below the light, 12 mm further out
  EXPECT_NEAR(size("bracket", 4).z(), 0.12 - 0.031 - 0.05, 1e-12);
  EXPECT_TRUE(place("bracket", 4).isApprox(Eigen::Vector3d(-0.212, 0, 0.0695), 1e-12));
  EXPECT_TRUE(place("bracket", 5).isApprox(Eigen::Vector3d(0.262, 0, 0.058), 1e-12));
}

TEST_F(Bracket, CarriesTheCameraThatIsNamed) {
  const double back = place("camera_body", 0).z() - size("camera_body", 0).z() / 2;
  const auto check = [&](const std::string& name, const Eigen::Vector3d& body) {
    set_up("camera_body=" + name);
    EXPECT_TRUE(size("camera_body", 0).isApprox(body, 1e-12)) << name;
    EXPECT_NEAR(place("camera_body", 0).z() - body.z() / 2, back, 1e-12) << name;
    const auto& lens = dynamic_cast<const urdf::Cylinder&>(*visual("camera_body", 1).geometry);
    EXPECT_NEAR(place("camera_body", 1).z() - lens.length / 2, back + body.z(), 1e-12) << name;
    EXPECT_TRUE(
        link_pose("flange", "camera_body").translation().isApprox(Eigen::Vector3d(0, 0, 0.085)));
  };
  check("photonfocus_mv1", {0.055, 0.055, 0.051});
  check("bluecougar", {0.04, 0.04, 0.035});
}

TEST_F(Bracket, RefusesWrongArgumentsByName) {
  const auto refused = [](const std::string& arguments) {
    int status = 0;
    const std::string text = printed(arguments, status);
    EXPECT_EQ(status, 1) << arguments;
    return text;
  };
  EXPECT_EQ(refused("laser_0_tilt=2"), "bracket: laser_0_tilt: '2'; give -1.4 .. 1.4 rad\n");
  EXPECT_EQ(refused("laser_1_height=low"), "bracket: laser_1_height: 'low'; give 0.085 .. 0.5 m\n");
  EXPECT_EQ(refused("laser_1_half_distance=nan"),
            "bracket: laser_1_half_distance: 'nan'; give 0.05 .. 0.3 m\n");
  EXPECT_EQ(refused("camera_body=sony"),
            "bracket: camera_body: 'sony'; give generic, photonfocus_mv1, bluecougar\n");
  EXPECT_EQ(refused("laser_0_tlit=0.3"),
            "bracket: laser_0_tlit: no such argument; did you mean laser_0_tilt?\n");
  EXPECT_NE(refused("laser_0_tilt=0.3 laser_0_tilt=0.4").find("laser_0_tilt: given twice"),
            std::string::npos);
  EXPECT_NE(refused("tilt").find("'tilt': no argument; write NAME=VALUE"), std::string::npos);
}
