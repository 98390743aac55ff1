// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <scan_cell_msgs/ArmTrigger.h>
#include <scan_cell_msgs/DisarmTrigger.h>
#include <std_msgs/Empty.h>

#include <algorithm>

#include "devices/ros_devices.h"
#include "scan_cell/ros/service_call.h"

namespace scan_cell {

using scan_cell_msgs::ArmTrigger;
using scan_cell_msgs::DisarmTrigger;

namespace {

/// [s] The robot moves during a call to the trigger. If the trigger's node hangs, its own
/// keep-alive switches the lasers off.
constexpr double kCallTimeout = 0.75;  // [s] chosen

ArmTrigger::Request request_for(double rate, const Lighting& lighting) {
  ArmTrigger::Request request;
  request.rate = rate;
  request.lasers = lighting.lasers;
  request.alternate = static_cast<unsigned char>(lighting.alternate);
  request.exposure = lighting.exposure;
  return request;
}

}  // namespace

RosTrigger::RosTrigger(ros::NodeHandle node, const Parameters& parameters)
    : parameters_(parameters) {
  keep_alive_publisher_ = node.advertise<std_msgs::Empty>(parameters.trigger + "/keep_alive", 1);
  event_subscriber_ =
      node.subscribe(parameters.trigger + "/events", 1000, &RosTrigger::on_event, this);
  state_subscriber_ =
      node.subscribe(parameters.trigger + "/state", 10, &RosTrigger::on_state, this);
}

void RosTrigger::on_event(const scan_cell_msgs::TriggerEvent& event) {
  event_.now();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (event.arming == arming_) pulses_ = std::max<std::uint64_t>(pulses_, event.count);
}

void RosTrigger::on_state(const scan_cell_msgs::TriggerState& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (arming_ != 0 && state.arming == arming_ && !state.armed) disarmed_because_ = state.message;
}

std::string RosTrigger::trouble() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (arming_ == 0) return "";
  if (!disarmed_because_.empty()) return "trigger: disarmed by itself: " + disarmed_because_;
  if (event_.age() <= silence_allowed_) return "";
  return fmt::format("trigger: no pulse for {:g} s after {}; is {} alive?", event_.age(), pulses_,
                     parameters_.trigger);
}

bool RosTrigger::check(double rate, const Lighting& lighting) {
  const std::string service = parameters_.trigger + "/check_arm";
  const std::string arm = parameters_.trigger + "/arm";
  if (!ros::service::exists(service, false) && ros::service::exists(arm, false)) return false;
  call<ArmTrigger>(service, request_for(rate, lighting), parameters_.call_timeout);
  return true;
}

void RosTrigger::arm(double rate, const Lighting& lighting) {
  keep_alive();
  const auto response =
      call<ArmTrigger>(parameters_.trigger + "/arm", request_for(rate, lighting), kCallTimeout);
  event_.now();
  const std::lock_guard<std::mutex> lock(mutex_);
  arming_ = response.arming;
  pulses_ = 0;
  disarmed_because_.clear();
  silence_allowed_ = parameters_.silence_allowed(rate);
}

Disarmed RosTrigger::disarm() noexcept {
  Disarmed disarmed;
  try {
    const auto answer = ask<DisarmTrigger>(parameters_.trigger + "/disarm", {}, kCallTimeout);
    disarmed.pulses = answer.pulses;
    if (!answer.success)
      disarmed.trouble = "trigger: the lasers may be on, disarming failed: " + answer.message;
  } catch (const scan_cell_common::Error& error) {
    disarmed.trouble = "trigger: not disarmed, its lasers go off by themselves: ";
    disarmed.trouble += error.what();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  disarmed.arming = arming_;
  arming_ = 0;
  disarmed.pulses = std::max(disarmed.pulses, pulses_);
  return disarmed;
}

void RosTrigger::keep_alive() {
  keep_alive_publisher_.publish(std_msgs::Empty());
}

}  // namespace scan_cell
