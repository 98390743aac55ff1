// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <scan_cell_common/ros/conversions.h>
#include <tf2_ros/transform_listener.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;
using Eigen::Vector3d;

namespace {

std::string folder;  // of scanner.yaml and cell.yaml

class CalibratedFramesNode : public testing::Test {
 protected:
  Eigen::Isometry3d pose(const std::string& of, const std::string& in) const {
    return scan_cell_common::from_ros(
        buffer_.lookupTransform(in, of, ros::Time(0), ros::Duration(60)).transform);
  }

  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_{buffer_};
};

/// What the node prints where it must end by itself.
std::string said_by(const std::string& arguments) {
  const std::string log =
      (fs::temp_directory_path() / ("frames_" + std::to_string(getpid()))).string();
  const std::string command =
      "timeout 60 rosrun scan_calibration calibrated_frames_node __name:=bad_frames " + arguments +
      " > " + log + " 2>&1";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1) << arguments;
  std::ifstream file(log);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  fs::remove(log);
  return text;
}

}  // namespace

TEST_F(CalibratedFramesNode, PublishesTheFramesOfItsFiles) {
  const Eigen::Isometry3d base = pose("base_link", "world");
  EXPECT_TRUE(base.translation().isApprox(Vector3d(-0.8, 0.05, 0.01), 1e-9));
  EXPECT_TRUE((base.linear() * Vector3d::UnitX()).isApprox(Vector3d::UnitY(), 1e-9));
  EXPECT_TRUE(pose("tool_tip", "tool0").translation().isApprox(Vector3d(0, 0, 0.2), 1e-9));
  EXPECT_TRUE(
      pose("camera_optical_frame", "tool0").translation().isApprox(Vector3d(0.01, 0, 0.1), 1e-9));
  for (const std::string laser : {"laser_0", "laser_1"}) {
    const Vector3d crossing =
        pose(laser, "camera_optical_frame") * Vector3d(0, 0, std::hypot(0.25, 0.5));
    EXPECT_TRUE(crossing.isApprox(Vector3d(0, 0, 0.5), 1e-9)) << laser;
  }
}

TEST(CalibratedFrames, RefuseToStartOnABadFileByTheNameOfTheEntry) {
  const std::string scanner = "_scanner_file:=" + folder + "/scanner.yaml";
  const std::string cell = "_cell_file:=" + folder + "/cell.yaml";
  EXPECT_NE(said_by(scanner).find("/bad_frames/cell_file: not set"), std::string::npos);
  EXPECT_NE(said_by("_scanner_file:=/no/such.yaml " + cell).find("/no/such.yaml"),
            std::string::npos);
  EXPECT_NE(said_by(scanner + " _cell_file:=" + folder + "/scanner.yaml").find("camera"),
            std::string::npos);
  EXPECT_NE(said_by(scanner + " " + cell + " _rate:=5").find("/bad_frames/rate"),
            std::string::npos);
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_calibrated_frames_node");
  const ros::NodeHandle node;
  folder = argv[1];
  return RUN_ALL_TESTS();
}
