// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <scan_cell_msgs/CheckFollow.h>
#include <scan_cell_msgs/CheckMotions.h>
#include <scan_cell_msgs/GetControllerParameter.h>
#include <scan_cell_msgs/GetStaticPose.h>
#include <scan_cell_msgs/MoveAction.h>
#include <scan_cell_msgs/SetControllerParameter.h>
#include <scan_cell_msgs/SetLinearSpeed.h>
#include <scan_cell_msgs/SetOverride.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include <vector>

#include "c4g_driver/client.h"
#include "driver_diagnostics.h"
#include "driver_parameters.h"
#include "jogger.h"
#include "path_follower.h"
#include "scan_cell_common/ros/listeners.h"

namespace c4g_driver {

/// The robot in ROS: its position, its state, and the action that moves it.
class DriverNode {
 public:
  DriverNode(ros::NodeHandle node, ros::NodeHandle private_node,
             const DriverParameters& parameters);

  const Client& client() const { return client_; }

 private:
  using MoveServer = actionlib::SimpleActionServer<scan_cell_msgs::MoveAction>;

  void publish(const MeasuredState& state);
  void publish_status();

  void move(const scan_cell_msgs::MoveGoalConstPtr& goal);
  void start(const scan_cell_msgs::MoveGoal& goal);
  Goal follow(const std::string& watcher);
  void finish(std::uint8_t outcome, const std::string& message);
  void finish(const Goal& end);

  template <class Service>
  void advertise(ros::NodeHandle& node, const std::string& name,
                 void (DriverNode::*handler)(const typename Service::Request&,
                                             typename Service::Response&));
  void set_override(const scan_cell_msgs::SetOverride::Request& request,
                    scan_cell_msgs::SetOverride::Response& response);
  void set_linear_speed(const scan_cell_msgs::SetLinearSpeed::Request& request,
                        scan_cell_msgs::SetLinearSpeed::Response& response);
  void set_drives(const std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  void reset_alarms(const std_srvs::Trigger::Request& request,
                    std_srvs::Trigger::Response& response);
  void check_motions(const scan_cell_msgs::CheckMotions::Request& request,
                     scan_cell_msgs::CheckMotions::Response& response);
  void check_follow(const scan_cell_msgs::CheckFollow::Request& request,
                    scan_cell_msgs::CheckFollow::Response& response);
  void get_static_pose(const scan_cell_msgs::GetStaticPose::Request& request,
                       scan_cell_msgs::GetStaticPose::Response& response);
  void get_parameter(const scan_cell_msgs::GetControllerParameter::Request& request,
                     scan_cell_msgs::GetControllerParameter::Response& response);
  void set_parameter(const scan_cell_msgs::SetControllerParameter::Request& request,
                     scan_cell_msgs::SetControllerParameter::Response& response);

  const DriverParameters parameters_;
  ros::Publisher transforms_;
  ros::Publisher joint_states_;
  scan_cell_common::Listeners listeners_;  // to the status
  ros::Publisher status_;
  bool was_up_ = false;
  std::uint64_t losses_ = 0;  // of the link that were reported
  LinkDiagnosis diagnosis_;

  // Filled and published for each pose by the client's thread, without allocation.
  tf2_msgs::TFMessage transform_;
  sensor_msgs::JointState joints_;

  // Later members use earlier ones from their own threads.
  Client client_;
  MoveServer server_;
  PathFollower path_follower_;
  Jogger jogger_;
  diagnostic_updater::Updater diagnostics_;
  ros::Timer status_timer_;

  // Service calls wait for the controller; a cancel or a lost client must not wait for a call.
  ros::CallbackQueue service_queue_;
  std::vector<ros::ServiceServer> services_;
  ros::AsyncSpinner service_spinner_{1, &service_queue_};
};

}  // namespace c4g_driver
