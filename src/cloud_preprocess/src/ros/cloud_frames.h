// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <scan_cell_common/parameters/parameter_table.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <string>

#include "cloud_preprocess/traced_cloud.h"

namespace cloud_preprocess {

/// Parameters of every nodelet besides those of its stages.
struct TargetFrame {
  std::string frame;   //!< empty: each cloud stays in its own frame
  double timeout = 1;  //!< [s]
};

void describe(scan_cell_common::ParameterTable& table, TargetFrame& target);

/// Transforms incoming clouds into the target frame.
class CloudFrames {
 public:
  /// Listens to /tf from now on if there is a target frame.
  void set_target(const TargetFrame& target, const ros::NodeHandle& node);

  /// The header of the output for an input with this header.
  std_msgs::Header header_of(const std_msgs::Header& header) const;

  /// A message's points in the target frame.
  /// @param[out] motion transform applied to them
  /// @throw scan_cell_common::Refused if /tf does not link the frames at the cloud's time
  /// @throw scan_cell_common::UnusableInput if the message has no float32 x, y, z
  TracedCloud places_of(const sensor_msgs::PointCloud2& message, Eigen::Isometry3f& motion) const;

 private:
  Eigen::Isometry3f motion_of(const std_msgs::Header& header) const;

  TargetFrame target_;
  tf2_ros::Buffer transforms_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;  // null without a target frame
};

/// The points of a cloud with all fields of the message they come from.
/// @param motion transform that brought them into the cloud's frame
sensor_msgs::PointCloud2Ptr to_message(const TracedCloud& cloud,
                                       const sensor_msgs::PointCloud2& source,
                                       const Eigen::Isometry3f& motion,
                                       const std_msgs::Header& header);

}  // namespace cloud_preprocess
