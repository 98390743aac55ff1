// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <ros/service.h>
#include <scan_cell_msgs/SetFaults.h>

inline scan_cell_msgs::SetFaults::Response set_faults(
    const scan_cell_msgs::SetFaults::Request& request = {}) {
  scan_cell_msgs::SetFaults::Response response;
  EXPECT_TRUE(ros::service::waitForService("/scan_cell_sim/set_faults", 30000));
  scan_cell_msgs::SetFaults::Request asked = request;
  EXPECT_TRUE(ros::service::call("/scan_cell_sim/set_faults", asked, response));
  return response;
}
