// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/node_handle.h>

#include <Eigen/Geometry>
#include <mutex>
#include <string>
#include <vector>

namespace scan_cell_demo {

/// True positions of the tool's tip, from the simulator's robot, tool and place in the world.
class TrueTip {
 public:
  /// @param simulator node
  /// @param cell the simulator's own cell file
  TrueTip(ros::NodeHandle node, const std::string& simulator, const std::string& cell);

  /// Forgets all positions so far.
  void clear();

  /// Positions in the world [m] since clear(), in order of time.
  std::vector<Eigen::Vector3d> way() const;

 private:
  void on_flange(const geometry_msgs::PoseStamped& flange);

  const Eigen::Isometry3d base_in_world_;
  const Eigen::Vector3d tip_in_flange_;
  mutable std::mutex mutex_;
  std::vector<Eigen::Vector3d> way_;
  ros::Subscriber subscriber_;  // last: its callback uses all other members
};

}  // namespace scan_cell_demo
