// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "devices/ros_stages.h"

#include <ros/node_handle.h>
#include <scan_cell_msgs/FinishBinding.h>
#include <scan_cell_msgs/FinishCloud.h>
#include <scan_cell_msgs/StartScan.h>

#include <set>

#include "scan_cell/ros/service_call.h"

namespace scan_cell {

using scan_cell_msgs::FinishBinding;
using scan_cell_msgs::FinishCloud;
using scan_cell_msgs::StartScan;

RosStages::RosStages(const std::string& binder, const std::string& triangulation,
                     double call_timeout)
    : binder_(binder), triangulation_(triangulation), call_timeout_(call_timeout) {}

double RosStages::longest(double patience) const {
  constexpr double kRounds = 4;  // chosen; patience begins anew while late data keeps coming
  return call_timeout_ + kRounds * patience;
}

void RosStages::clear() {
  under_way_ = false;
  audit_ = {};
  binding_.clear();
  statistics_ = {};
  cloud_ = {};
  cloud_file_.clear();
}

std::string RosStages::trouble() const {
  const auto lost = [](const std::string& node) {
    return node + ": lost the connection to it; did the node die?";
  };
  if (!under_way_) return "";
  if (!binder_line_.isValid()) return lost(binder_);
  if (!triangulation_line_.isValid()) return lost(triangulation_);
  return "";
}

void RosStages::start(const std::string& scan_id) {
  clear();
  StartScan::Request request;
  request.scan_id = scan_id;
  call<StartScan>(triangulation_ + "/start", request, call_timeout_);
  call<StartScan>(binder_ + "/start", request, call_timeout_);
  constexpr bool kPersistent = true;
  ros::NodeHandle node;
  binder_line_ = node.serviceClient<FinishBinding>(finish_binding(), kPersistent);
  triangulation_line_ = node.serviceClient<FinishCloud>(finish_cloud(), kPersistent);
  under_way_ = true;
}

std::uint64_t RosStages::bind(std::uint64_t pulses, double patience) {
  under_way_ = false;
  FinishBinding::Request request;
  request.triggers = pulses;
  request.timeout = ros::Duration(patience);
  const auto bound = ask<FinishBinding>(finish_binding(), request, longest(patience));
  audit_ = bound.audit;
  binding_ = bound.message;
  check_answer(finish_binding(), bound);

  std::set<std::uint64_t> without_frame;
  for (const scan_cell_msgs::DroppedFrame& dropped : audit_.dropped) {
    if (dropped.reason == scan_cell_msgs::DroppedFrame::NEVER_ARRIVED) {
      without_frame.insert(dropped.trigger_count);
    }
  }
  std::uint64_t missing = 0;
  while (missing < pulses && without_frame.count(pulses - missing) > 0)
    ++missing;
  return missing;
}

void RosStages::triangulate(bool whole, double patience) {
  FinishCloud::Request request;
  request.profiles = audit_.frames_bound;
  request.timeout = ros::Duration(patience);
  request.partial = !whole;
  const auto response = ask<FinishCloud>(finish_cloud(), request, longest(patience));
  statistics_ = response.statistics;
  cloud_ = response.cloud;  // also where it failed: what was captured is kept
  cloud_file_ = response.file;
  check_answer(finish_cloud(), response);
}

}  // namespace scan_cell
