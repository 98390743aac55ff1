// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <scan_cell_msgs/LoadWorld.h>
#include <scan_cell_msgs/SetFaults.h>

#include <string>

#include "lost_pulses.h"
#include "parameters.h"

namespace scan_cell_sim {

/// The simulated hardware, and its control and observation over ROS, for tests.
class SimulatorServices {
 public:
  /// @throw as Controller, Cell, load_world() and load_scanner_model()
  SimulatorServices(ros::NodeHandle node, const Parameters& parameters);
  ~SimulatorServices();

 private:
  bool load(scan_cell_msgs::LoadWorld::Request& request,
            scan_cell_msgs::LoadWorld::Response& response);
  bool set(scan_cell_msgs::SetFaults::Request& request,
           scan_cell_msgs::SetFaults::Response& response);
  void apply(const scan_cell_msgs::SetFaults::Request& request);
  /// Acts as somebody at the controller's panel would.
  void attend(const scan_cell_msgs::SetFaults::Request& request);
  void publish_parts(const World& world);
  void publish_robot(const ros::WallTimerEvent& event);
  void publish_exposure(const Cell::TrueExposure& exposure);

  Controller controller_;
  Cell cell_;
  ros::Publisher parts_;
  ros::Publisher flange_;
  ros::Publisher outputs_;
  ros::Publisher exposures_;
  ros::ServiceServer load_world_;
  ros::ServiceServer set_faults_;
  ros::WallTimer timer_;
  LostPulses lost_pulses_;
};

}  // namespace scan_cell_sim
