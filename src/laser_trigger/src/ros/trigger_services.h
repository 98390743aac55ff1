// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <scan_cell_msgs/ArmTrigger.h>
#include <scan_cell_msgs/DisarmTrigger.h>
#include <std_msgs/Empty.h>

#include <memory>
#include <mutex>
#include <string>

#include "laser_trigger/pulse_generator.h"
#include "parameters.h"
#include "scan_cell_common/ros/listeners.h"

namespace laser_trigger {

/// The trigger's topics, services and diagnostics.
class TriggerServices {
 public:
  TriggerServices(ros::NodeHandle node, const Parameters& parameters, TriggerPort& port,
                  Guardian& guardian);

  /// Ends the current arming: the lines are low when this returns.
  void shut_down(const std::string& reason);

 private:
  using ArmEvent =
      ros::ServiceEvent<scan_cell_msgs::ArmTrigger::Request, scan_cell_msgs::ArmTrigger::Response>;

  bool arm(ArmEvent& event);
  bool check_arm(scan_cell_msgs::ArmTrigger::Request& request,
                 scan_cell_msgs::ArmTrigger::Response& response);
  bool disarm(scan_cell_msgs::DisarmTrigger::Request& request,
              scan_cell_msgs::DisarmTrigger::Response& response);
  void on_listener_gone(const std::string& node);
  void end_of_client();
  void on_pulse(const Pulse& pulse);
  void publish_state();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  scan_cell_common::Listeners listeners_;  // to the state
  ros::Publisher events_;
  ros::Publisher state_;
  std::mutex state_mutex_;   // keeps the state published last the latest
  std::mutex client_mutex_;  // guards client_; held while arming
  std::string client_;       // the subscriber that armed it; empty: none
  std::unique_ptr<PulseGenerator> generator_;
  ros::Subscriber keep_alive_;
  ros::ServiceServer arm_;
  ros::ServiceServer check_arm_;
  ros::ServiceServer disarm_;
  diagnostic_updater::Updater diagnostics_;
  ros::Timer diagnostics_timer_;
};

}  // namespace laser_trigger
