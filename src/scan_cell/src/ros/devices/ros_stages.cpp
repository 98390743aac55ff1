// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "devices/ros_stages.h"

#include <fmt/format.h>
#include <ros/node_handle.h>
#include <scan_cell_msgs/FinishBinding.h>
#include <scan_cell_msgs/FinishCloud.h>
#include <scan_cell_msgs/StartRun.h>
#include <scan_cell_msgs/StartScan.h>

#include <map>
#include <set>
#include <utility>

#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"

namespace scan_cell {

using scan_cell_msgs::FinishBinding;
using scan_cell_msgs::FinishCloud;
using scan_cell_msgs::StartRun;
using scan_cell_msgs::StartScan;

RosStages::RosStages(const std::string& binder, const std::string& triangulation,
                     double call_timeout, const std::string& base_frame)
    : binder_(binder),
      triangulation_(triangulation),
      call_timeout_(call_timeout),
      base_frame_(base_frame) {
  constexpr unsigned kQueue = 1000;  // runs; a program has few
  told_ = ros::NodeHandle("~").advertise<scan_cell_msgs::ScanRun>("runs", kQueue);
}

double RosStages::longest(double patience) const {
  constexpr double kRounds = 4;  // chosen; patience restarts while late data keeps arriving
  return call_timeout_ + kRounds * patience;
}

void RosStages::clear() {
  runs_.clear();
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
  scan_id_ = scan_id;
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

scan_cell_msgs::ScanRun RosStages::message_of(const ScanRun& run) const {
  scan_cell_msgs::ScanRun message;
  message.header.stamp = ros::Time::now();
  message.scan_id = scan_id_;
  message.pass_index = static_cast<std::uint32_t>(run.pass);
  message.straight = run.moves.size() == 1 && !run.moves.front().via;
  message.start.header.frame_id = message.end.header.frame_id = base_frame_;
  message.start.pose = scan_cell_common::to_ros_pose(run.start);
  message.end.pose = scan_cell_common::to_ros_pose(run.moves.back().flange);
  message.speed = run.speed;
  message.rate = run.rate;
  message.lasers = run.lighting.lasers;
  return message;
}

void RosStages::check_run(const ScanRun& run) {
  StartRun::Request request;
  request.run = message_of(run);
  for (const std::string& node : {binder_, triangulation_}) {
    const auto answer = ask<StartRun>(node + "/check_run", request, call_timeout_);
    if (answer.success != 0) continue;
    throw scan_cell_common::Refused(run.name, "refused by " + node, answer.message);
  }
}

void RosStages::start_run(const ScanRun& run) {
  StartRun::Request request;
  request.run = message_of(run);
  call<StartRun>(binder_ + "/start_run", request, call_timeout_);
  runs_.push_back(run.name);
  told_.publish(request.run);
}

std::vector<std::uint64_t> RosStages::bind(const std::vector<ArmingPulses>& armings,
                                           double patience) {
  under_way_ = false;
  FinishBinding::Request request;
  for (const ArmingPulses& arming : armings)
    request.triggers += arming.pulses;
  request.timeout = ros::Duration(patience);
  const auto bound = ask<FinishBinding>(finish_binding(), request, longest(patience));
  audit_ = bound.audit;
  binding_ = bound.message;
  check_answer(finish_binding(), bound);
  check_each_bound(armings);

  std::set<std::pair<std::uint32_t, std::uint64_t>> without_frame;  // arming, pulse
  for (const scan_cell_msgs::DroppedFrame& dropped : audit_.dropped) {
    if (dropped.reason == scan_cell_msgs::DroppedFrame::NEVER_ARRIVED)
      without_frame.emplace(dropped.arming, dropped.trigger_count);
  }
  std::vector<std::uint64_t> missing;
  for (const ArmingPulses& arming : armings) {
    std::uint64_t last = arming.pulses;
    while (last > 0 && without_frame.count({arming.arming, last}) > 0)
      --last;
    missing.push_back(arming.pulses - last);
  }
  return missing;
}

/// An arming without any frame is left to bind(): there the camera was lost.
void RosStages::check_each_bound(const std::vector<ArmingPulses>& armings) const {
  using scan_cell_msgs::DroppedFrame;
  std::map<std::uint32_t, std::set<std::uint64_t>> unbound;  // pulses by arming
  std::map<std::uint32_t, std::string> why;                  // of the first frame
  for (const DroppedFrame& dropped : audit_.dropped) {
    unbound[dropped.arming].insert(dropped.trigger_count);
    if (dropped.reason != DroppedFrame::NEVER_ARRIVED) why.emplace(dropped.arming, dropped.detail);
  }
  for (std::size_t i = 0; i < armings.size(); ++i) {
    const auto reason = why.find(armings[i].arming);
    if (reason == why.end() || unbound[armings[i].arming].size() < armings[i].pulses) continue;
    // Armings without a pulse are not included: then no name is certain.
    const std::string name =
        runs_.size() == armings.size() ? runs_[i] : fmt::format("arming {}", armings[i].arming);
    throw scan_cell_common::Refused(
        name, fmt::format("no frame of its {} pulses was bound", armings[i].pulses),
        "the first: " + reason->second);
  }
}

void RosStages::triangulate(bool whole, double patience) {
  FinishCloud::Request request;
  request.profiles = audit_.frames_bound;
  request.timeout = ros::Duration(patience);
  request.partial = !whole;
  const auto response = ask<FinishCloud>(finish_cloud(), request, longest(patience));
  statistics_ = response.statistics;
  cloud_ = response.cloud;  // even on failure: what was captured is kept
  cloud_file_ = response.file;
  check_answer(finish_cloud(), response);
}

std::string RosStages::disagreement() const {
  if (statistics_.agreement != scan_cell_msgs::CloudStatistics::DISAGREE) return "";
  return "the passes disagree: " + statistics_.agreement_message;
}

}  // namespace scan_cell
