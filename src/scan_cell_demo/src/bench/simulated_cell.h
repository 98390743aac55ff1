// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <scan_cell_msgs/BindingAudit.h>
#include <scan_cell_msgs/BoundProfile.h>
#include <scan_cell_msgs/MoveAction.h>
#include <scan_cell_msgs/RobotStatus.h>

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "running_cell/started_cell.h"
#include "scan_cell_common/pose/timed_pose.h"

namespace scan_cell_demo {

/// A motion of the flange.
struct Motion {
  std::string name;
  Eigen::Isometry3d target = Eigen::Isometry3d::Identity();  //!< tool0 in world
  bool in_joints = false;                //!< all axes together; false: along a line
  double speed = 0.25;                   //!< [m/s] along a line
  double acceleration = 1;               //!< [m/s^2] along a line
  std::vector<double> override = {100};  //!< [%] in turn, each for `hold`
  double hold = 0.4;                     //!< [s]

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
};

/// The frames of one scan, bound by two binders, and their true poses.
struct Scan {
  struct Bound {
    std::vector<scan_cell_msgs::BoundProfileConstPtr> profiles;
    scan_cell_msgs::BindingAudit audit;
  };
  Bound interpolated;
  Bound first_pose;
  std::map<std::uint64_t, Eigen::Isometry3d> truth;  //!< tool0 in world, by device time [ns]
};

/// The shipped cell with simulated hardware, in its own processes under its own ROS master. This
/// program is another node.
class SimulatedCell {
 public:
  /// @param launch_file of the cell
  /// @throw scan_cell_common::Refused if the cell does not come up
  explicit SimulatedCell(const std::string& launch_file);

  /// Moves the flange and waits until the robot stands still.
  void move(const Motion& motion);

  /// Scans with laser_0 from before the motion until after it.
  /// @param rate [Hz] of the frames
  Scan scan(const Motion& motion, double rate);

  static void load_world(const std::string& path);
  static void set_controller_parameter(const std::string& name, const std::string& json);

  /// Delays all messages from the controller [s]. Returns when the driver's map of the clocks
  /// contains no earlier message.
  static void delay_controller(double delay);

  ros::NodeHandle& node() { return node_; }

  /// @throw scan_cell_common::Refused after a minute
  void wait_until(const std::string& what, const std::function<bool()>& met);

 private:
  void wait_until_up();
  template <class Message, class Take>
  void listen(const std::string& topic, const Take& take);
  void start_stages();
  void finish_stages(std::uint64_t pulses);
  static void acquire(std::uint8_t mode);

  StartedCell started_;
  ros::NodeHandle node_;
  Eigen::Isometry3d base_link_;  // in world
  std::mutex mutex_;             // guards the next two
  Scan scan_;
  bool connected_ = false;
  std::vector<ros::Subscriber> subscribers_;
  ros::Publisher keep_alive_;
  ros::WallTimer keeper_;
  actionlib::SimpleActionClient<scan_cell_msgs::MoveAction> robot_{"/c4g_driver/move", false};
};

}  // namespace scan_cell_demo
