// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "running_cell/followed_path.h"

#include <fmt/format.h>
#include <scan_cell_msgs/GetStaticPose.h>

#include <algorithm>

#include "running_cell/nodes.h"
#include "running_cell/running_cell.h"
#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/ros/conversions.h"

namespace scan_cell_demo {
namespace {

constexpr const char* kDriver = "/c4g_driver";
constexpr double kCallTimeout = 10;  // [s]
constexpr double kTaken = 20;        // [s] until the path is loaded and begun
constexpr double kSpeed = 0.1;       // [m/s] of the tip
constexpr double kZone = 1e-3;       // [m]
constexpr double kTipLength = 0.1;   // [m] of the tool
constexpr int kTimes = 2;            // to and fro

}  // namespace

FollowedPath::FollowedPath(ros::NodeHandle node, const std::vector<Eigen::Isometry3d>& line)
    : node_(node), line_(line), client_(node, std::string(kDriver) + "/follow") {
  flange_ = node_.subscribe("/scan_cell_sim/true_flange", 1000, &FollowedPath::on_flange, this);
  outputs_ = node_.subscribe("/scan_cell_sim/true_outputs", 1000, &FollowedPath::on_outputs, this);
}

scan_cell_msgs::FollowGoal FollowedPath::goal(const Eigen::Isometry3d& from) const {
  constexpr double kThere = 1e-3;  // [m] two waypoints in one place make no path
  const Eigen::Isometry3d flange_to_tip(Eigen::Translation3d(0, 0, kTipLength));
  scan_cell_msgs::FollowGoal goal;
  goal.header.frame_id = "base_link";
  goal.flange_to_tip = scan_cell_common::to_ros_pose(flange_to_tip);
  goal.watcher = ros::this_node::getName();
  const auto add = [&](const Eigen::Isometry3d& flange) {
    scan_cell_msgs::FollowWaypoint waypoint;
    waypoint.tip = scan_cell_common::to_ros_pose(flange * flange_to_tip);
    waypoint.speed = kSpeed;
    waypoint.zone = kZone;
    waypoint.outputs = 1;
    goal.waypoints.push_back(waypoint);
  };
  add(from);
  if ((line_.front().translation() - from.translation()).norm() > kThere) add(line_.front());
  for (int i = 0; i < kTimes; ++i) {
    add(line_.back());
    add(line_.front());
  }
  return goal;
}

void FollowedPath::start() {
  const auto stands = scan_cell::call<scan_cell_msgs::GetStaticPose>(
      std::string(kDriver) + "/get_static_pose", {}, kCallTimeout);
  wait_until("the driver's action", [this] { return client_.is_connected(); });
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    progress_ = 0;
    places_.clear();
  }
  client_.send(goal(scan_cell_common::from_ros(stands.pose.pose)), {}, [this](const auto& news) {
    const std::lock_guard<std::mutex> lock(mutex_);
    progress_ = news.progress;
  });
  client_.wait_until_taken(kTaken);
}

void FollowedPath::wait_for_share(double share) {
  wait_until(fmt::format("{:.0f} % of the path", 100 * share), [&] {
    if (const auto end = client_.end())
      throw EndedBefore("the path", "ended before the blow",
                        end->result ? end->result->message : end->state.getText());
    const std::lock_guard<std::mutex> lock(mutex_);
    return progress_ >= share && on_;
  });
}

scan_cell_msgs::FollowResultConstPtr FollowedPath::end() {
  wait_until("the end of the path", [this] { return client_.end() || !client_.is_connected(); });
  const auto end = client_.end();
  return end ? end->result : nullptr;
}

FollowedPath::Rest FollowedPath::rest(Nanoseconds struck) const {
  constexpr double kSamePlace = 1e-6;  // [m]
  wait_until("all outputs off", [&] {
    const std::lock_guard<std::mutex> lock(mutex_);
    return !on_ && outputs_heard_ > struck && !places_.empty() && places_.back().time > struck;
  });
  const std::lock_guard<std::mutex> lock(mutex_);
  Rest rest;
  rest.outputs_on = std::max(0.0, scan_cell_common::to_seconds(off_since_ - struck));
  for (std::size_t i = 1; i < places_.size(); ++i) {
    if ((places_[i].place - places_[i - 1].place).norm() > kSamePlace)
      rest.moving = std::max(rest.moving, scan_cell_common::to_seconds(places_[i].time - struck));
  }
  return rest;
}

bool FollowedPath::is_on() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return on_;
}

int FollowedPath::switched_on() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return switched_on_;
}

void FollowedPath::on_flange(const geometry_msgs::PoseStamped& flange) {
  constexpr std::size_t kKept = 20000;  // minutes; chosen
  const std::lock_guard<std::mutex> lock(mutex_);
  if (places_.size() == kKept) places_.pop_front();
  places_.push_back({scan_cell_common::from_ros(flange.header.stamp),
                     scan_cell_common::from_ros(flange.pose).translation()});
}

void FollowedPath::on_outputs(const scan_cell_msgs::ToolOutputs& outputs) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool was_on = on_;
  on_ = outputs.outputs != 0;
  outputs_heard_ = scan_cell_common::from_ros(outputs.header.stamp);
  if (on_ && !was_on) ++switched_on_;
  if (!on_ && was_on) off_since_ = outputs_heard_;
}

}  // namespace scan_cell_demo
