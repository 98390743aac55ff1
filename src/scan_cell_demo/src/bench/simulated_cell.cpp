// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_cell.h"

#include <fmt/format.h>
#include <ros/package.h>
#include <scan_cell_msgs/ArmTrigger.h>
#include <scan_cell_msgs/DisarmTrigger.h>
#include <scan_cell_msgs/FinishBinding.h>
#include <scan_cell_msgs/FinishCloud.h>
#include <scan_cell_msgs/LoadWorld.h>
#include <scan_cell_msgs/SetAcquisition.h>
#include <scan_cell_msgs/SetControllerParameter.h>
#include <scan_cell_msgs/SetFaults.h>
#include <scan_cell_msgs/SetLinearSpeed.h>
#include <scan_cell_msgs/SetOverride.h>
#include <scan_cell_msgs/StartScan.h>
#include <scan_cell_msgs/TriggerEvent.h>
#include <std_msgs/Empty.h>

#include "running_cell/nodes.h"
#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/ros/conversions.h"
#include "scan_cell_sim/cell.h"

namespace scan_cell_demo {

using scan_cell::call;
using scan_cell_common::Refused;
using scan_cell_msgs::BoundProfileConstPtr;
using scan_cell_msgs::MoveGoal;
using scan_cell_msgs::MoveResult;
using scan_cell_msgs::SetAcquisition;

namespace {

constexpr double kPatience = 60;  // [s]
constexpr std::uint32_t kUnbounded = 0;

}  // namespace

SimulatedCell::SimulatedCell(const std::string& launch_file)
    : started_("bench_cloud_error", {launch_file}, ""),
      base_link_(scan_cell_sim::load_base_link_in_world(ros::package::getPath("scan_cell_sim") +
                                                        "/config/cell.yaml")) {
  for (const auto& [binder, bound] : {std::pair("/pose_frame_binder", &Scan::interpolated),
                                      std::pair("/first_pose_binder", &Scan::first_pose)}) {
    listen<scan_cell_msgs::BoundProfile>(std::string(binder) + "/bound_profiles",
                                         [this, to = bound](const BoundProfileConstPtr& profile) {
                                           (scan_.*to).profiles.push_back(profile);
                                         });
  }
  listen<geometry_msgs::PoseStamped>("/scan_cell_sim/true_exposures",
                                     [this](const geometry_msgs::PoseStampedConstPtr& exposure) {
                                       scan_.truth[exposure->header.stamp.toNSec()] =
                                           base_link_ * scan_cell_common::from_ros(exposure->pose);
                                     });
  listen<scan_cell_msgs::RobotStatus>("/c4g_driver/status",
                                      [this](const scan_cell_msgs::RobotStatusConstPtr& status) {
                                        connected_ = status->connected;
                                      });
  keep_alive_ = node_.advertise<std_msgs::Empty>("/laser_trigger/keep_alive", 1);
  constexpr double kKeepAlive = 0.1;  // [s]
  keeper_ = node_.createWallTimer(
      ros::WallDuration(kKeepAlive),
      [this](const ros::WallTimerEvent&) { keep_alive_.publish(std_msgs::Empty()); });
  wait_until_up();
}

template <class Message, class Take>
void SimulatedCell::listen(const std::string& topic, const Take& take) {
  const boost::function<void(const boost::shared_ptr<const Message>&)> on_message =
      [this, take](const boost::shared_ptr<const Message>& message) {
        const std::lock_guard<std::mutex> lock(mutex_);
        take(message);
      };
  subscribers_.push_back(node_.subscribe<Message>(topic, kUnbounded, on_message));
}

void SimulatedCell::wait_until_up() {
  for (const char* service :
       {"/camera/set_acquisition", "/first_pose_binder/start", "/laser_triangulation/start",
        "/laser_trigger/arm", "/pose_frame_binder/start", "/scan_cell_sim/set_faults"}) {
    wait_until(service, [service] { return ros::service::exists(service, false); });
  }
  for (const ros::Subscriber& subscriber : subscribers_) {
    wait_until(subscriber.getTopic(), [&] { return subscriber.getNumPublishers() > 0; });
  }
  wait_until("keep_alive", [this] { return keep_alive_.getNumSubscribers() > 0; });
  wait_until("the robot's action", [this] { return robot_.isServerConnected(); });
  wait_until("the robot", [this] { return connected_; });
  wait_until("the camera", [] {
    SetAcquisition::Request stop;
    stop.mode = SetAcquisition::Request::STOP;
    return scan_cell::ask<SetAcquisition>("/camera/set_acquisition", stop, kPatience).success;
  });
}

void SimulatedCell::wait_until(const std::string& what, const std::function<bool()>& met) {
  scan_cell_demo::wait_until(what, [&] {
    const std::lock_guard<std::mutex> lock(mutex_);
    return met();
  });
}

void SimulatedCell::load_world(const std::string& path) {
  scan_cell_msgs::LoadWorld::Request request;
  request.path = path;
  call<scan_cell_msgs::LoadWorld>("/scan_cell_sim/load_world", request, kPatience);
}

void SimulatedCell::set_controller_parameter(const std::string& name, const std::string& json) {
  scan_cell_msgs::SetControllerParameter::Request request;
  request.name = name;
  request.value = json;
  call<scan_cell_msgs::SetControllerParameter>("/c4g_driver/set_parameter", request, kPatience);
}

void SimulatedCell::delay_controller(double delay) {
  scan_cell_msgs::SetFaults::Request faults;
  faults.robot_delayed_packets = delay > 0 ? 1 : 0;
  faults.robot_delay = delay;
  call<scan_cell_msgs::SetFaults>("/scan_cell_sim/set_faults", faults, kPatience);
  constexpr double kClockWindow = 2;  // [s] of the driver
  ros::WallDuration(1.5 * kClockWindow).sleep();
}

void SimulatedCell::move(const Motion& motion) {
  const auto set_override = [](double percent) {
    scan_cell_msgs::SetOverride::Request request;
    request.override = percent;
    call<scan_cell_msgs::SetOverride>("/c4g_driver/set_override", request, kPatience);
  };
  using scan_cell_common::kMillimetres;
  set_controller_parameter("motion_type", motion.in_joints ? "\"joint\"" : "\"linear\"");
  set_controller_parameter("linear_acceleration",
                           fmt::format("{}", motion.acceleration * kMillimetres));
  scan_cell_msgs::SetLinearSpeed::Request speed;
  speed.speed = motion.speed;
  call<scan_cell_msgs::SetLinearSpeed>("/c4g_driver/set_linear_speed", speed, kPatience);
  set_override(motion.override.front());

  MoveGoal goal;
  goal.kind = MoveGoal::CARTESIAN;
  goal.pose.header.frame_id = "base_link";
  goal.pose.pose = scan_cell_common::to_ros_pose(base_link_.inverse() * motion.target);
  robot_.sendGoal(goal);
  std::size_t held = 0;
  while (!robot_.waitForResult(ros::Duration(motion.hold))) {
    if (!ros::ok()) throw Refused(motion.name, "stopped", "let it run to its end");
    if (motion.override.size() > 1) set_override(motion.override[++held % motion.override.size()]);
  }
  if (robot_.getResult()->outcome != MoveResult::REACHED)
    throw Refused(motion.name, robot_.getResult()->message, "give another motion");
}

void SimulatedCell::acquire(std::uint8_t mode) {
  SetAcquisition::Request request;
  request.mode = mode;
  request.trigger = SetAcquisition::Request::EXTERNAL_TRIGGER;
  call<SetAcquisition>("/camera/set_acquisition", request, kPatience);
}

Scan SimulatedCell::scan(const Motion& motion, double rate) {
  start_stages();
  acquire(SetAcquisition::Request::RELIEF_ONLY);
  scan_cell_msgs::ArmTrigger::Request arm;
  arm.rate = rate;
  arm.lasers = scan_cell_msgs::TriggerEvent::LASER_0;
  call<scan_cell_msgs::ArmTrigger>("/laser_trigger/arm", arm, kPatience);
  move(motion);
  const std::uint64_t pulses =
      call<scan_cell_msgs::DisarmTrigger>("/laser_trigger/disarm", {}, kPatience).pulses;
  finish_stages(pulses);
  acquire(SetAcquisition::Request::STOP);
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::move(scan_);
}

void SimulatedCell::start_stages() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    scan_ = {};
  }
  scan_cell_msgs::StartScan::Request request;
  request.scan_id = "bench";
  for (const char* stage : {"/laser_triangulation", "/pose_frame_binder", "/first_pose_binder"})
    call<scan_cell_msgs::StartScan>(std::string(stage) + "/start", request, kPatience);
}

void SimulatedCell::finish_stages(std::uint64_t pulses) {
  scan_cell_msgs::FinishBinding::Request finish;
  finish.triggers = pulses;
  finish.timeout = ros::Duration(5);
  const auto bind = [&](const std::string& binder) {
    return call<scan_cell_msgs::FinishBinding>(binder + "/finish", finish, kPatience).audit;
  };
  const auto interpolated = bind("/pose_frame_binder");
  const auto first_pose = bind("/first_pose_binder");
  scan_cell_msgs::FinishCloud::Request cloud;
  cloud.profiles = interpolated.frames_bound;
  cloud.timeout = ros::Duration(5);
  cloud.partial = true;  // skips the later stages
  call<scan_cell_msgs::FinishCloud>("/laser_triangulation/finish", cloud, kPatience);
  wait_until("the bound profiles", [&] {
    return scan_.interpolated.profiles.size() == interpolated.frames_bound &&
           scan_.first_pose.profiles.size() == first_pose.frames_bound &&
           scan_.truth.size() >= interpolated.frames;
  });
  const std::lock_guard<std::mutex> lock(mutex_);
  scan_.interpolated.audit = interpolated;
  scan_.first_pose.audit = first_pose;
}

}  // namespace scan_cell_demo
