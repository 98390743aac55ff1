// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <limits>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/cloud_messages.h"

using scan_cell_common::Cloud;
using scan_cell_common::from_message;
using scan_cell_common::to_message;
using scan_cell_common::UnusableInput;

namespace {

sensor_msgs::PointCloud2 two_points() {
  Cloud cloud;
  cloud.push_back({0.1F, 0.2F, 0.3F});
  cloud.push_back({-1.0F, std::numeric_limits<float>::quiet_NaN(), 1e-4F});
  std_msgs::Header header;
  header.frame_id = "world";
  header.stamp = ros::Time(12, 34);
  return to_message(cloud, header);
}

}  // namespace

TEST(CloudMessages, KeepPointsAndHeader) {
  const sensor_msgs::PointCloud2 message = two_points();
  EXPECT_EQ(message.header.frame_id, "world");
  EXPECT_EQ(message.header.stamp, ros::Time(12, 34));
  const Cloud cloud = from_message(message);
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud[0].y, 0.2F);
  EXPECT_TRUE(std::isnan(cloud[1].y));
  EXPECT_EQ(cloud[1].z, 1e-4F);
}

TEST(CloudMessages, AreReadAmongOtherFields) {
  sensor_msgs::PointCloud2 message;
  sensor_msgs::PointCloud2Modifier modifier(message);
  modifier.setPointCloud2Fields(
      4, "intensity", 1, sensor_msgs::PointField::FLOAT32, "x", 1, sensor_msgs::PointField::FLOAT32,
      "y", 1, sensor_msgs::PointField::FLOAT32, "z", 1, sensor_msgs::PointField::FLOAT32);
  modifier.resize(1);
  *sensor_msgs::PointCloud2Iterator<float>(message, "z") = 7.0F;
  EXPECT_EQ(from_message(message)[0].z, 7.0F);
}

TEST(CloudMessages, AreRefusedWithoutXyzOrWithTheWrongSize) {
  sensor_msgs::PointCloud2 no_z = two_points();
  no_z.fields[2].name = "height";
  EXPECT_THROW(from_message(no_z), UnusableInput);
  sensor_msgs::PointCloud2 double_x = two_points();
  double_x.fields[0].datatype = sensor_msgs::PointField::FLOAT64;
  EXPECT_THROW(from_message(double_x), UnusableInput);
  sensor_msgs::PointCloud2 cut = two_points();
  cut.data.pop_back();
  EXPECT_THROW(from_message(cut), UnusableInput);
}

TEST(CloudMessages, MayBeEmpty) {
  EXPECT_TRUE(from_message(to_message(Cloud(), std_msgs::Header())).empty());
}
