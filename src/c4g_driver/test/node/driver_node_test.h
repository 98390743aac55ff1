// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <scan_cell_msgs/MoveAction.h>
#include <scan_cell_msgs/RobotStatus.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "scan_cell_common/ros/conversions.h"
#include "scan_cell_sim/controller/controller.h"

/// The node on real topics, against an emulated controller in this process, whose truth is known.
namespace driver_node_test {

using scan_cell_common::from_ros;
using scan_cell_msgs::MoveGoal;
using scan_cell_msgs::MoveResult;
using scan_cell_msgs::RobotStatus;
using GoalState = actionlib::SimpleClientGoalState;
using MoveClient = actionlib::SimpleActionClient<scan_cell_msgs::MoveAction>;

inline const ros::Duration kPatience(20);

inline Eigen::Isometry3d looking_down(double x, double y, double z) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << x, y, z;
  pose.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  return pose;
}

inline MoveGoal to_pose(const Eigen::Isometry3d& pose) {
  MoveGoal goal;
  goal.kind = MoveGoal::CARTESIAN;
  goal.pose.header.frame_id = "base_link";
  goal.pose.pose = scan_cell_common::to_ros_pose(pose);
  goal.camera_rate = 100;
  return goal;
}

inline MoveGoal along_arc(const Eigen::Isometry3d& via, const Eigen::Isometry3d& pose) {
  MoveGoal goal = to_pose(pose);
  goal.kind = MoveGoal::CIRCULAR;
  goal.via = to_pose(via).pose;
  return goal;
}

inline MoveGoal to_joints(const std::vector<double>& joints) {
  MoveGoal goal;
  goal.kind = MoveGoal::JOINT;
  goal.joints = joints;
  return goal;
}

inline bool eventually(const std::function<bool()>& condition, double seconds = 20) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(seconds);
  while (ros::WallTime::now() < deadline) {
    if (condition()) return true;
    ros::WallDuration(0.005).sleep();
  }
  return condition();
}

inline double distance(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.translation() - b.translation()).norm();
}

template <class Message>
class Latest {
 public:
  Latest(ros::NodeHandle& node, const std::string& topic)
      : subscriber_(
            node.subscribe<Message>(topic, 1000, [this](const typename Message::ConstPtr& message) {
              const std::lock_guard<std::mutex> lock(mutex_);
              all_.push_back(*message);
            })) {}
  std::vector<Message> all() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return all_;
  }
  bool is(const std::function<bool(const Message&)>& condition) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return !all_.empty() && condition(all_.back());
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Message> all_;
  ros::Subscriber subscriber_;
};

class Driver : public testing::Test {
 protected:
  void SetUp() override {
    scan_cell_sim::ControllerOptions options;
    options.port = 35410;
    controller_ = std::make_unique<scan_cell_sim::Controller>(options);
    ASSERT_TRUE(move_.waitForServer(kPatience));
    ASSERT_TRUE(connected(true));
  }

  void TearDown() override {
    move_.cancelAllGoals();
    controller_.reset();
    EXPECT_TRUE(connected(false)) << "the driver must notice that the controller is gone";
  }

  bool connected(bool wanted) {
    return eventually([this, wanted] {
      return status_.is([wanted](const RobotStatus& status) { return status.connected == wanted; });
    });
  }

  /// Moves, and returns the result however the motion ended.
  MoveResult run(const MoveGoal& goal) {
    move_.sendGoal(goal);
    EXPECT_TRUE(move_.waitForResult(kPatience));
    return move_.getResult() ? *move_.getResult() : MoveResult();
  }

  /// Starts a long motion, and waits until the robot is well under way.
  void start_long_move() {
    move_.sendGoal(to_pose(looking_down(0.80, 0.35, 0.60)));
    ASSERT_TRUE(
        eventually([this] { return controller_->state().flange.translation().y() > 0.03; }));
  }

  Eigen::Isometry3d truth() const { return controller_->state().flange; }

  template <class Service>
  typename Service::Response call(const std::string& name,
                                  const typename Service::Request& request) {
    Service service;
    service.request = request;
    EXPECT_TRUE(ros::service::call("/c4g_driver/" + name, service));
    return service.response;
  }

  template <class Request, class Value>
  static Request with(Value Request::*field, const Value& value) {
    Request request;
    request.*field = value;
    return request;
  }

  /// base_link -> tool0 since the test began.
  std::vector<geometry_msgs::TransformStamped> flange_transforms() const {
    std::vector<geometry_msgs::TransformStamped> result;
    for (const auto& message : transforms_.all()) {
      for (const auto& transform : message.transforms) {
        if (transform.child_frame_id == "tool0") result.push_back(transform);
      }
    }
    return result;
  }

  ros::NodeHandle node_;
  std::unique_ptr<scan_cell_sim::Controller> controller_;
  Latest<RobotStatus> status_{node_, "/c4g_driver/status"};
  Latest<tf2_msgs::TFMessage> transforms_{node_, "/tf"};
  Latest<sensor_msgs::JointState> joints_{node_, "/joint_states"};
  MoveClient move_{"/c4g_driver/move", true};
};

}  // namespace driver_node_test
