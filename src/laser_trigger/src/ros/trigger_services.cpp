// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "trigger_services.h"

#include <scan_cell_msgs/TriggerEvent.h>
#include <scan_cell_msgs/TriggerState.h>

#include "scan_cell_common/ros/conversions.h"
#include "scan_cell_common/ros/service_answer.h"

namespace laser_trigger {

using scan_cell_msgs::ArmTrigger;
using scan_cell_msgs::DisarmTrigger;

namespace {

PulseGenerator::Arming arming_of(const ArmTrigger::Request& request) {
  constexpr bool kPulses = true;
  return {request.rate, request.lasers,         request.longest_on.toSec(),
          kPulses,      request.alternate != 0, request.exposure};
}

}  // namespace

TriggerServices::TriggerServices(ros::NodeHandle node, const Parameters& parameters,
                                 TriggerPort& port, Guardian& guardian)
    : listeners_([this](const std::string& gone) { on_listener_gone(gone); }) {
  constexpr std::uint32_t kEvents = 100000;   // for a slow subscriber: 100 s at 1 kHz; chosen
  constexpr std::uint32_t kStates = 10;       // for a slow subscriber; chosen
  constexpr double kDiagnosticsPeriod = 0.2;  // [s] chosen
  events_ = node.advertise<scan_cell_msgs::TriggerEvent>("events", kEvents);
  state_ = listeners_.advertise<scan_cell_msgs::TriggerState>(node, "state", kStates, true);
  generator_ = std::make_unique<PulseGenerator>(
      port, &guardian, parameters.pulses,
      PulseGenerator::Observer{[this](const Pulse& pulse) { on_pulse(pulse); },
                               [this] { publish_state(); }});
  const boost::function<void(const std_msgs::EmptyConstPtr&)> keep_alive =
      [this](const std_msgs::EmptyConstPtr&) { generator_->keep_alive(); };
  keep_alive_ = node.subscribe<std_msgs::Empty>("keep_alive", 1, keep_alive);
  arm_ = node.advertiseService("arm", &TriggerServices::arm, this);
  check_arm_ = node.advertiseService("check_arm", &TriggerServices::check_arm, this);
  disarm_ = node.advertiseService("disarm", &TriggerServices::disarm, this);
  diagnostics_.setHardwareID(parameters.port.name());
  diagnostics_.add("trigger", this, &TriggerServices::diagnose);
  diagnostics_timer_ = node.createTimer(ros::Duration(kDiagnosticsPeriod),
                                        [this](const ros::TimerEvent&) { diagnostics_.update(); });
  publish_state();
  if (parameters.pulses.realtime_priority > 0 && !generator_->why_not_realtime().empty())
    ROS_WARN("pulses without real-time scheduling: %s", generator_->why_not_realtime().c_str());
}

void TriggerServices::shut_down(const std::string& reason) {
  generator_->disarm(reason);
}

void TriggerServices::on_listener_gone(const std::string& node) {
  const std::lock_guard<std::mutex> lock(client_mutex_);
  if (node == client_) end_of_client();
}

void TriggerServices::end_of_client() {
  generator_->disarm("its client " + client_ + " is gone");
  client_.clear();
}

bool TriggerServices::arm(ArmEvent& event) {
  const ArmTrigger::Request& request = event.getRequest();
  ArmTrigger::Response& response = event.getResponse();
  const std::lock_guard<std::mutex> lock(client_mutex_);
  const std::string& caller = event.getCallerName();
  const bool listened = listeners_.contains(caller);
  return scan_cell_common::answer(response, [&] {
    response.arming = generator_->arm(arming_of(request));
    client_ = listened ? caller : "";
    if (listened && !listeners_.contains(caller)) end_of_client();
  });
}

bool TriggerServices::check_arm(ArmTrigger::Request& request, ArmTrigger::Response& response) {
  return scan_cell_common::answer(response, [&] { generator_->check(arming_of(request)); });
}

bool TriggerServices::disarm(DisarmTrigger::Request&, DisarmTrigger::Response& response) {
  const TriggerStatus ended = generator_->disarm("disarmed by the client");
  response.success = ended.failure.empty();
  response.message = ended.failure;
  response.arming = ended.arming;
  response.pulses = ended.pulses;
  return true;
}

void TriggerServices::on_pulse(const Pulse& pulse) {
  scan_cell_msgs::TriggerEvent event;
  event.header.stamp = scan_cell_common::to_ros(pulse.time);
  event.arming = pulse.arming;
  event.count = pulse.count;
  event.lasers = pulse.lasers;
  events_.publish(event);
}

void TriggerServices::publish_state() {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  const TriggerStatus status = generator_->status();
  scan_cell_msgs::TriggerState state;
  state.header.stamp = ros::Time::now();
  state.armed = status.armed;
  state.arming = status.arming;
  state.pulses = status.pulses;
  state.rate = status.rate;
  state.lasers = status.lasers;
  state.alternate = status.alternate;
  state.message = status.message;
  state_.publish(state);
}

void TriggerServices::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using Level = diagnostic_msgs::DiagnosticStatus;
  const TriggerStatus now = generator_->status();
  status.summary(now.missed == 0 ? Level::OK : Level::WARN,
                 now.missed == 0 ? (now.armed ? "armed" : "disarmed") : "deadlines missed");
  status.add("armed", now.armed);
  status.add("arming", now.arming);
  status.add("rate [Hz]", now.rate);
  status.add("lasers", static_cast<int>(now.lasers));
  status.add("lasers alternate", now.alternate);
  status.add("pulses", now.pulses);
  status.add("missed deadlines", now.missed);
  status.add("not real-time because", generator_->why_not_realtime());
  constexpr double kMilliseconds = 1e3;  // in a second
  status.add("latest pulse [ms]", now.latest * kMilliseconds);
  status.add("disarmed because", now.message);
}

}  // namespace laser_trigger
