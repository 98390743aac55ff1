// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <string>

namespace pose_frame_binder {

/// The static transforms of /tf_static.
class StaticTransforms {
 public:
  explicit StaticTransforms(ros::NodeHandle node);

  /// Pose of `child` in `parent`.
  /// @param timeout [s] to wait for it
  /// @throw scan_cell_common::Refused if no static transforms connect them
  Eigen::Isometry3d look_up(const std::string& parent, const std::string& child,
                            double timeout) const;

 private:
  void on_transforms(const tf2_msgs::TFMessage& message);

  tf2::BufferCore buffer_;
  ros::Subscriber subscriber_;
};

}  // namespace pose_frame_binder
