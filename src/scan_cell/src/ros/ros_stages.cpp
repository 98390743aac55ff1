// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/ros/ros_stages.h"

#include <scan_cell_msgs/FinishBinding.h>
#include <scan_cell_msgs/FinishCloud.h>
#include <scan_cell_msgs/StartScan.h>

#include "scan_cell/ros/service_call.h"

namespace scan_cell {

using scan_cell_msgs::FinishBinding;
using scan_cell_msgs::FinishCloud;
using scan_cell_msgs::StartScan;

RosStages::RosStages(const std::string& binder, const std::string& triangulation,
                     double call_timeout)
    : binder_(binder), triangulation_(triangulation), call_timeout_(call_timeout) {}

void RosStages::clear() {
  audit_ = {};
  binding_.clear();
  statistics_ = {};
  cloud_ = {};
}

void RosStages::start(const std::string& scan_id) {
  clear();
  StartScan::Request request;
  request.scan_id = scan_id;
  call<StartScan>(triangulation_ + "/start", request, call_timeout_);
  call<StartScan>(binder_ + "/start", request, call_timeout_);
}

void RosStages::finish(std::uint64_t pulses, double patience) {
  FinishBinding::Request binding;
  binding.triggers = pulses;
  binding.timeout = ros::Duration(patience);
  const std::string finish_binding = binder_ + "/finish";
  const auto bound = ask<FinishBinding>(finish_binding, binding, call_timeout_ + patience);
  audit_ = bound.audit;
  binding_ = bound.message;

  FinishCloud::Request cloud;
  cloud.profiles = audit_.frames_bound;
  cloud.timeout = ros::Duration(patience);
  const std::string finish_cloud = triangulation_ + "/finish";
  const auto response = ask<FinishCloud>(finish_cloud, cloud, call_timeout_ + patience);
  statistics_ = response.statistics;
  cloud_ = response.cloud;              // also where it failed: what was captured is kept
  check_answer(finish_binding, bound);  // first: what it missed the cloud misses, too
  check_answer(finish_cloud, response);
}

}  // namespace scan_cell
