// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <scan_cell_msgs/ObjectClouds.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Trigger.h>
#include <unistd.h>

#include <filesystem>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/ros/cloud_messages.h"
#include "synthetic_parts.h"
#include "tool_path_stretcher/surface.h"

using sensor_msgs::PointCloud2;
using tool_path_stretcher::Points;

namespace {

const ros::Duration kLong(60);  // allows for a busy machine

/// The panel, and beside it a small one whose size is out of range for the reference.
scan_cell_common::Cloud scene(const synthetic::Part& panel) {
  Points points;
  for (const auto& [scale, y] : {std::pair{1.0, 0.0}, {0.3, 0.2}}) {
    const Points more =
        synthetic::scan(panel, synthetic::similarity(scale, Eigen::Matrix3d::Identity(), {0, y, 0}),
                        synthetic::no_deformation(), {});
    points.insert(points.end(), more.begin(), more.end());
  }
  return tool_path_stretcher::to_cloud(points);
}

std_srvs::Trigger::Response apply() {
  std_srvs::Trigger trigger;
  EXPECT_TRUE(ros::service::call("preprocess/apply", trigger));
  return trigger.response;
}

}  // namespace

TEST(CleanByReference, IsChosenWhileTheNodeRuns) {
  ros::NodeHandle node;
  const auto file =
      std::filesystem::temp_directory_path() / ("reference_" + std::to_string(getpid()) + ".ply");
  const synthetic::Part frame = synthetic::photo_frame();
  const synthetic::Part panel = synthetic::curved_panel();
  ASSERT_TRUE(ros::service::waitForService("preprocess/apply", kLong));

  ros::param::set("preprocess/isolate/select", "reference");
  const auto nameless = apply();
  EXPECT_FALSE(nameless.success);
  EXPECT_NE(nameless.message.find("isolate/reference"), std::string::npos) << nameless.message;

  synthetic::Scan how;
  how.seed = 11;
  const auto save = [&](const synthetic::Part& part) {
    scan_cell_common::save_cloud(file.string(), tool_path_stretcher::to_cloud(synthetic::scan(
                                                    part, {}, synthetic::no_deformation(), how)));
  };
  save(panel);
  ros::param::set("preprocess/isolate/reference", file.string());
  EXPECT_TRUE(apply().success);
  ros::Publisher scan = node.advertise<PointCloud2>("scan", 1, true);
  std_msgs::Header header;
  header.frame_id = "world";
  header.stamp = ros::Time(1000, 5);
  scan.publish(scan_cell_common::to_message(scene(panel), header));
  const auto clean = ros::topic::waitForMessage<PointCloud2>("preprocess/clean_cloud", kLong);
  ASSERT_NE(clean, nullptr);
  const auto part = scan_cell_common::from_message(*clean);
  EXPECT_GT(part.size(), 19000U);
  for (const auto& point : part)
    ASSERT_LT(point.y, 0.12) << "a point of the small one";
  const auto objects =
      ros::topic::waitForMessage<scan_cell_msgs::ObjectClouds>("preprocess/objects", kLong);
  ASSERT_NE(objects, nullptr);
  EXPECT_EQ(objects->clouds.size(), 2U);

  save(frame);
  const auto refused = apply();
  EXPECT_FALSE(refused.success);
  EXPECT_NE(refused.message.find("explains none of 2 objects"), std::string::npos)
      << refused.message;
  std::filesystem::remove(file);
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_clean_by_reference");
  const ros::NodeHandle node;  // keeps ROS up
  return RUN_ALL_TESTS();
}
