// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "client/clean_cloud_watch.h"
#include "scan_cell_common/errors/errors.h"

using scan_cell::CleanCloudWatch;

namespace {

constexpr double kTimeout = 30;  // [s] far more than any step takes
constexpr int kWatches = 300;    // one destroyed too early crashed within 20

sensor_msgs::PointCloud2 cloud_of(int number) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header.stamp = ros::Time(static_cast<double>(number));
  cloud.width = static_cast<std::uint32_t>(number);
  return cloud;
}

scan_cell_msgs::PreprocessReport failure_of(int number) {
  scan_cell_msgs::PreprocessReport report;
  report.header.stamp = ros::Time(static_cast<double>(number));
  report.stage = "largest_object";
  report.message = "no points are left";
  return report;
}

/// Publishes clouds and failures, one after the other, until it is destroyed.
class BusyCell {
 public:
  explicit BusyCell(const ros::NodeHandle& node) : node_(node), thread_([this] { publish(); }) {}
  ~BusyCell() {
    going_ = false;
    thread_.join();
  }

 private:
  void publish() {
    for (int number = 1; going_; ++number) {
      clouds_.publish(cloud_of(number));
      reports_.publish(failure_of(-number + 2'000'000'000));
      std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
  }

  ros::NodeHandle node_;
  ros::Publisher clouds_ = node_.advertise<sensor_msgs::PointCloud2>("clean", 10);
  ros::Publisher reports_ = node_.advertise<scan_cell_msgs::PreprocessReport>("report", 10);
  std::atomic<bool> going_{true};
  std::thread thread_;
};

}  // namespace

TEST(CleanCloudWatch, GivesTheCloudOfTheScan) {
  ros::NodeHandle node;
  const auto clouds = node.advertise<sensor_msgs::PointCloud2>("clean", 10, true);
  CleanCloudWatch watch(node, "clean", "report");
  for (const int number : {1, 2, 3})
    clouds.publish(cloud_of(number));
  EXPECT_EQ(watch.wait(ros::Time(2), kTimeout).width, 2U);
}

TEST(CleanCloudWatch, TellsTheStageThatFailed) {
  ros::NodeHandle node;
  const auto reports = node.advertise<scan_cell_msgs::PreprocessReport>("report", 10, true);
  CleanCloudWatch watch(node, "clean", "report");
  reports.publish(failure_of(2));
  try {
    watch.wait(ros::Time(2), kTimeout);
    FAIL();
  } catch (const scan_cell_common::Refused& refused) {
    EXPECT_NE(std::string(refused.what()).find("largest_object"), std::string::npos);
    EXPECT_NE(std::string(refused.what()).find("no points are left"), std::string::npos);
  }
}

TEST(CleanCloudWatch, MayGoWhileCloudsCome) {
  ros::NodeHandle node;
  const BusyCell cell(node);
  for (int i = 0; i < kWatches; ++i) {
    CleanCloudWatch watch(node, "clean", "report");
    EXPECT_THROW(watch.wait(ros::Time(0.5), 0.01), scan_cell_common::ConnectionError);
  }
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_clean_cloud_watch");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
