// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <scan_cell_common/ros/conversions.h>
#include <scan_cell_msgs/TriggerEvent.h>
#include <scan_cell_msgs/TriggerState.h>
#include <tf2_ros/transform_listener.h>
#include <unistd.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

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

/// Plays the trigger's node, and receives the sheets as rviz does.
class SheetsOfLight : public testing::Test {
 protected:
  SheetsOfLight() {
    states_ = node_.advertise<scan_cell_msgs::TriggerState>("trigger_state", 10, true);
    pulses_ = node_.advertise<scan_cell_msgs::TriggerEvent>("trigger_events", 10);
    const boost::function<void(const visualization_msgs::MarkerArray&)> look =
        [this](const visualization_msgs::MarkerArray& array) {
          for (const visualization_msgs::Marker& marker : array.markers)
            seen_[marker.ns] = marker;
        };
    markers_ = node_.subscribe<visualization_msgs::MarkerArray>("/calibrated_frames/light_sheets",
                                                                10, look);
  }

  void say(bool armed, int lasers) {
    scan_cell_msgs::TriggerState state;
    state.armed = static_cast<unsigned char>(armed);
    state.lasers = static_cast<std::uint8_t>(lasers);
    state.rate = 100;
    states_.publish(state);
  }

  bool shows(const std::string& laser) {
    return seen_.count(laser) > 0 && seen_[laser].action == visualization_msgs::Marker::ADD;
  }

  /// Whether a condition comes true, with a pulse of `lasers` before each check (0: without
  /// pulses).
  bool comes_to(const std::function<bool()>& condition, int lasers) {
    constexpr int kLooks = 3000;  // a minute
    constexpr double kLook = 0.02;
    for (int look = 0; look < kLooks && !condition(); ++look) {
      scan_cell_msgs::TriggerEvent pulse;
      pulse.lasers = static_cast<std::uint8_t>(lasers);
      if (lasers != 0) pulses_.publish(pulse);
      ros::WallDuration(kLook).sleep();
      ros::spinOnce();
    }
    return condition();
  }

  ros::NodeHandle node_;
  ros::Publisher states_, pulses_;
  ros::Subscriber markers_;
  std::map<std::string, visualization_msgs::Marker> seen_;
};

/// Output of the node when it must end by itself.
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

TEST_F(SheetsOfLight, AppearWhileTheirLaserBurnsAndVanishWhenItIsOff) {
  say(true, 1);
  ASSERT_TRUE(comes_to([&] { return shows("laser_0"); }, 1));
  EXPECT_FALSE(shows("laser_1"));
  const visualization_msgs::Marker& sheet = seen_["laser_0"];
  EXPECT_EQ(sheet.header.frame_id, "laser_0");
  ASSERT_EQ(sheet.points.size(), 3U);
  const double length = std::hypot(0.25, 0.5);  // the fan opens 90 degrees: half as wide as long
  EXPECT_NEAR(sheet.points[0].z, 0, 1e-12);
  for (const std::size_t end : {1, 2}) {
    EXPECT_NEAR(sheet.points[end].x, 0, 1e-12);
    EXPECT_NEAR(std::abs(sheet.points[end].y), length, 1e-9);
    EXPECT_NEAR(sheet.points[end].z, length, 1e-9);
  }
  say(true, 3);
  EXPECT_TRUE(comes_to([&] { return shows("laser_0") && shows("laser_1"); }, 3));
  say(false, 0);
  EXPECT_TRUE(comes_to([&] { return !shows("laser_0") && !shows("laser_1"); }, 3));
}

TEST_F(SheetsOfLight, VanishWhenTheTriggersNodeDiesWithoutAWord) {
  say(true, 2);
  ASSERT_TRUE(comes_to([&] { return shows("laser_1"); }, 2));
  EXPECT_TRUE(comes_to([&] { return !shows("laser_1"); }, 0));
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_calibrated_frames_node");
  const ros::NodeHandle node;
  folder = argv[1];
  return RUN_ALL_TESTS();
}
