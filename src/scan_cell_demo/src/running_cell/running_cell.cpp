// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "running_cell/running_cell.h"

#include <fmt/format.h>
#include <ros/package.h>
#include <scan_cell_msgs/GrabImage.h>

#include <algorithm>

#include "running_cell/nodes.h"
#include "scan_cell/ros/scan_goal.h"
#include "scan_cell/ros/service_call.h"
#include "scan_cell/videe_command.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"
#include "scan_cell_sim/cell.h"

namespace scan_cell_demo {

using scan_cell_common::Refused;
using scan_cell_msgs::SetFaults;

namespace {

constexpr double kPatience = 60;  // [s]
constexpr double kLook = 0.01;    // [s] between two checks
constexpr double kStill = 0.3;    // [s] at one place
constexpr int kSteps = 8;         // of a scan

scan_cell::ScanProgram shipped(const std::string& name) {
  return scan_cell::load_scan_program(ros::package::getPath("scan_cell") + "/config/" + name);
}

bool grabs_an_image() {
  try {
    return scan_cell::ask<scan_cell_msgs::GrabImage>("/scan_cell/grab_image", {}, kPatience)
        .success;
  } catch (const scan_cell_common::ConnectionError&) {
    return false;  // the cell is starting, or restarting
  }
}

}  // namespace

RunningCell::RunningCell(ros::NodeHandle node)
    : node_(node),
      line_(shipped("scan_line.yaml")),
      program_(shipped("three_passes.yaml")),
      base_link_(scan_cell_sim::load_base_link_in_world(ros::package::getPath("scan_cell_sim") +
                                                        "/config/cell.yaml")) {
  feedback_ = node_.subscribe("/scan_cell/scan/feedback", 10, &RunningCell::on_feedback, this);
  results_ = node_.subscribe("/scan_cell/scan/result", 10, &RunningCell::on_result, this);
  flange_ = node_.subscribe("/scan_cell_sim/true_flange", 10, &RunningCell::on_flange, this);
  status_ = node_.subscribe("/c4g_driver/status", 10, &RunningCell::on_status, this);
}

void RunningCell::wait_until_well() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    connected_ = false;  // a driver that died may have reported otherwise
  }
  videe_.reset();
  wait_until("the cell", [this] { return scan_.is_connected(); });
  wait_until("the simulator",
             [] { return ros::service::exists("/scan_cell_sim/set_faults", false); });
  constexpr bool kStaysConnected = true;
  faults_ = node_.serviceClient<SetFaults>("/scan_cell_sim/set_faults", kStaysConnected);
  set_faults({});
  wait_until("the robot", [this] { return connected(); });
  wait_until("the trigger", [] { return ros::service::exists("/laser_trigger/arm", false); });
  wait_until("an image of the camera", [] { return grabs_an_image(); });
}

scan_cell::ScanProgram RunningCell::line() const {
  scan_cell::ScanProgram program = line_;
  std::vector<Eigen::Isometry3d>& poses = program.passes.front().poses;
  const Eigen::Vector3d place = look().place;
  if ((poses.front().translation() - place).norm() < (poses.back().translation() - place).norm())
    std::reverse(poses.begin(), poses.end());
  return program;
}

std::vector<Eigen::Isometry3d> RunningCell::line_in_base() const {
  std::vector<Eigen::Isometry3d> ends = line_.passes.front().poses;
  for (Eigen::Isometry3d& pose : ends)
    pose = base_link_.inverse() * pose;
  return ends;
}

void RunningCell::forget_last_scan() {
  const std::lock_guard<std::mutex> lock(mutex_);
  step_ = {};
  progress_ = 0;
  result_.reset();
}

void RunningCell::start_scan(const std::string& scan_id) {
  start(line(), scan_id);
}

void RunningCell::start_program(const std::string& scan_id) {
  start(program_, scan_id);
}

void RunningCell::start(const scan_cell::ScanProgram& program, const std::string& scan_id) {
  forget_last_scan();
  scan_.send(scan_cell::scan_goal(program, scan_id));
}

void RunningCell::stop_scan() {
  scan_.cancel();
}

void RunningCell::start_videe_scan(std::uint16_t port) {
  forget_last_scan();
  wait_until("videe_node", [&] {
    try {
      videe_.emplace(port);
      return true;
    } catch (const scan_cell_common::ConnectionError&) {
      return false;  // starting, or restarting
    }
  });
  const scan_cell::ScanPass pass = line().passes.front();
  videe_->ask("SET_POSITION " + scan_cell::pose_to_wire(pass.poses.front()) + " " +
              scan_cell::pose_to_wire(pass.poses.back()));
  videe_->ask("START_SCAN");
}

void RunningCell::wait_for_step(int step, double share) {
  const double wanted = (step - 1 + share) / kSteps;
  wait_until(fmt::format("step {}", step), [&] {
    throw_if_ended();
    const std::lock_guard<std::mutex> lock(mutex_);
    return step_.step == step && progress_ >= wanted;
  });
}

void RunningCell::wait_in_scan(double time) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(time);
  wait_until("the moment of the blow", [&] {
    throw_if_ended();
    return ros::WallTime::now() >= deadline;
  });
}

void RunningCell::throw_if_ended() const {
  const auto end = result();
  if (end) throw EndedBefore("the scan", "ended before the blow", end->result.message);
}

RunningCell::Step RunningCell::step() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return step_;
}

scan_cell_msgs::ScanResultConstPtr RunningCell::end() {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kPatience);
  auto end = result();
  for (; !end && scan_.is_connected(); end = result()) {
    if (ros::WallTime::now() > deadline)
      throw Refused("the scan", "does not end", "see the cell's log");
    ros::WallDuration(kLook).sleep();
  }
  if (!end) return nullptr;
  return scan_cell_msgs::ScanResultConstPtr(end, &end->result);  // shares ownership of `end`
}

scan_cell_msgs::ScanActionResultConstPtr RunningCell::result() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return result_;
}

void RunningCell::set_faults(const SetFaults::Request& faults) {
  SetFaults service;
  service.request = faults;
  if (!faults_.call(service)) throw Refused("the simulator", "does not answer", "see its log");
  scan_cell::check_answer("set_faults", service.response);
}

void RunningCell::wait_until_standing() {
  start_to_look();
  wait_until("the robot at rest", [this] { return look().still >= kStill; });
}

double RunningCell::way_within(double time) {
  start_to_look();
  wait_until("the robot's true pose", [this] { return look().heard > 0; });
  const Eigen::Vector3d from = look().place;
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(time);
  double way = 0;
  while (ros::WallTime::now() < deadline) {
    ros::WallDuration(kLook).sleep();
    way = std::max(way, (look().place - from).norm());
  }
  return way;
}

void RunningCell::start_to_look() {
  const std::lock_guard<std::mutex> lock(mutex_);
  flange_seen_.heard = 0;
  flange_seen_.still = 0;
}

RunningCell::Seen RunningCell::look() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return flange_seen_;
}

bool RunningCell::connected() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return connected_;
}

void RunningCell::on_feedback(const scan_cell_msgs::ScanActionFeedback& feedback) {
  const std::lock_guard<std::mutex> lock(mutex_);
  step_ = {feedback.feedback.pass_number, feedback.feedback.step};
  progress_ = feedback.feedback.progress;
}

void RunningCell::on_result(const scan_cell_msgs::ScanActionResultConstPtr& result) {
  const std::lock_guard<std::mutex> lock(mutex_);
  result_ = result;
}

void RunningCell::on_flange(const geometry_msgs::PoseStamped& flange) {
  constexpr double kSamePlace = 1e-5;  // [m]
  const std::lock_guard<std::mutex> lock(mutex_);
  const Eigen::Vector3d place =
      (base_link_ * scan_cell_common::from_ros(flange.pose)).translation();
  Seen& seen = flange_seen_;
  if (seen.heard == 0 || (place - seen.anchor).norm() > kSamePlace) {
    seen.anchor = place;
    seen.since = flange.header.stamp;
  }
  seen.still = (flange.header.stamp - seen.since).toSec();
  ++seen.heard;
  seen.place = place;
}

void RunningCell::on_status(const scan_cell_msgs::RobotStatus& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  connected_ = status.connected;
}

}  // namespace scan_cell_demo
