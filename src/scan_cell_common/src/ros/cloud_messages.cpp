// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/ros/cloud_messages.h"

#include <fmt/format.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <utility>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {
namespace {

void check_data(const sensor_msgs::PointCloud2& message) {
  const std::size_t points = std::size_t{message.width} * message.height;
  if (message.data.size() != points * message.point_step) {
    throw UnusableInput("cloud message: data",
                        fmt::format("{} bytes for {} points of {}", message.data.size(), points,
                                    message.point_step),
                        "send whole points without padding between rows");
  }
  if (message.is_bigendian) {
    throw UnusableInput("cloud message: byte order", "big endian", "send little endian");
  }
}

}  // namespace

CloudView view_of(const sensor_msgs::PointCloud2& message) {
  check_data(message);
  CloudView cloud;
  for (const sensor_msgs::PointField& field : message.fields) {
    if (field.count == 1)
      cloud.fields.push_back({field.name, static_cast<FieldType>(field.datatype), field.offset});
  }
  cloud.step = message.point_step;
  cloud.data = message.data.data();
  cloud.bytes = message.data.size();
  return cloud;
}

Cloud from_message(const sensor_msgs::PointCloud2& message) {
  return places_of(view_of(message));
}

sensor_msgs::PointCloud2 to_message(const Cloud& cloud, const std_msgs::Header& header) {
  sensor_msgs::PointCloud2 message;
  message.header = header;
  sensor_msgs::PointCloud2Modifier modifier(message);
  modifier.setPointCloud2Fields(3, "x", 1, sensor_msgs::PointField::FLOAT32, "y", 1,
                                sensor_msgs::PointField::FLOAT32, "z", 1,
                                sensor_msgs::PointField::FLOAT32);
  modifier.resize(cloud.size());
  message.is_dense = cloud.is_dense;
  if (cloud.empty()) return message;
  sensor_msgs::PointCloud2Iterator<float> x(message, "x"), y(message, "y"), z(message, "z");
  for (const pcl::PointXYZ& point : cloud) {
    *x = point.x, *y = point.y, *z = point.z;
    ++x, ++y, ++z;
  }
  return message;
}

sensor_msgs::PointCloud2 to_message(FieldedCloud cloud, const std_msgs::Header& header) {
  sensor_msgs::PointCloud2 message;
  message.header = header;
  for (const CloudField& field : cloud.fields) {
    sensor_msgs::PointField& entry = message.fields.emplace_back();
    entry.name = field.name;
    entry.datatype = static_cast<std::uint8_t>(field.type);
    entry.offset = static_cast<std::uint32_t>(field.offset);
    entry.count = 1;
  }
  message.height = 1;
  message.width = static_cast<std::uint32_t>(cloud.size());
  message.point_step = static_cast<std::uint32_t>(cloud.step);
  message.row_step = static_cast<std::uint32_t>(cloud.bytes.size());
  message.is_dense = true;
  message.data = std::move(cloud.bytes);
  return message;
}

}  // namespace scan_cell_common
