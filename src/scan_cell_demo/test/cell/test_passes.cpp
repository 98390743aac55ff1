// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Programs of passes in the simulated cell, against its ground truth.
#include <gtest/gtest.h>
#include <ros/package.h>
#include <ros/ros.h>
#include <scan_cell_msgs/LoadWorld.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <map>
#include <utility>

#include "scan_cell/ros/cell_client.h"
#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/ros/cloud_messages.h"
#include "scan_cell_demo/comparison.h"

using scan_cell_msgs::ScanResult;

namespace {

constexpr double kTimeout = 90;  // [s]

std::string world(const std::string& name) {
  return ros::package::getPath("scan_cell_sim") + "/config/" + name;
}

class Passes : public testing::Test {
 protected:
  /// Tries again while the nodes come up.
  ScanResult scan(const std::string& program) {
    scan_cell_msgs::LoadWorld::Request request;
    request.path = world("reference_frame.yaml");
    EXPECT_TRUE(ros::service::waitForService("/scan_cell_sim/load_world", ros::Duration(kTimeout)));
    scan_cell::call<scan_cell_msgs::LoadWorld>("/scan_cell_sim/load_world", request, kTimeout);
    const auto passes =
        scan_cell::load_scan_program(ros::package::getPath("scan_cell") + "/config/" + program);
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kTimeout);
    ScanResult result;
    do {
      result = cell_.scan(passes, program, kTimeout, [](const std::string&, double) {});
    } while (result.outcome == ScanResult::ROBOT_LOST && result.passes_finished == 0 &&
             ros::WallTime::now() < deadline);
    EXPECT_EQ(result.outcome, ScanResult::FINISHED) << result.message;
    return result;
  }

  /// Points of each pass and laser.
  static std::map<std::pair<int, int>, std::size_t> points_of(const ScanResult& result) {
    std::map<std::pair<int, int>, std::size_t> points;
    sensor_msgs::PointCloud2ConstIterator<std::uint8_t> pass(result.cloud, "pass");
    sensor_msgs::PointCloud2ConstIterator<std::uint8_t> laser(result.cloud, "laser");
    for (; pass != pass.end(); ++pass, ++laser)
      ++points[{*pass, *laser}];
    return points;
  }

  static double error(const ScanResult& result) {
    return scan_cell_demo::cloud_rms(scan_cell_common::from_message(result.cloud),
                                     world("reference_frame.yaml"));
  }

  static void expect_passes_agree(const ScanResult& result, std::size_t pairs) {
    EXPECT_EQ(result.statistics.overlaps.size(), pairs);
    for (const scan_cell_msgs::PassOverlap& overlap : result.statistics.overlaps)
      EXPECT_LE(overlap.median, 0.1e-3) << int{overlap.pass_one} << ", " << int{overlap.pass_other};
  }

  ros::NodeHandle node_;
  scan_cell::CellClient cell_{node_, {}};
};

}  // namespace

TEST_F(Passes, WithAlternatingLasersSeeBothFlanksInOneSweep) {
  const ScanResult result = scan("both_lasers.yaml");
  const auto points = points_of(result);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_GT(points.at({0, 0}), 100000U);
  EXPECT_GT(points.at({0, 1}), 100000U);
  EXPECT_LE(error(result), 0.2e-3) << "a point from the wrong plane is centimetres off";
  expect_passes_agree(result, 1);
}

TEST_F(Passes, OfAProgramComeIntoOneCloudThatKeepsThemApart) {
  const ScanResult result = scan("three_passes.yaml");
  EXPECT_EQ(result.passes_finished, 3U);
  const auto points = points_of(result);
  ASSERT_EQ(points.size(), 5U);
  for (const auto& [sweep, count] : points)
    EXPECT_GT(count, 20000U) << sweep.first << ", " << sweep.second;
  EXPECT_EQ(points.count({2, 0}), 0U);
  EXPECT_LE(error(result), 0.2e-3);
  expect_passes_agree(result, 10);
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_passes");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
