// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <scan_cell_msgs/ScanAction.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace scan_test {

using scan_cell_msgs::ScanResult;
using State = actionlib::SimpleClientGoalState;

/// A client of scan_cell_node within the fake cell (fake_cell.py), which logs what is done to it.
class ScanClient : public testing::Test {
 protected:
  using Client = actionlib::SimpleActionClient<scan_cell_msgs::ScanAction>;

  /// Waits until a scan finishes, however slowly the nodes come up.
  static void SetUpTestSuite() {
    ros::param::set("/fake/move_time", 0.1);
    Client client("/scan_cell/scan", false);
    ASSERT_TRUE(client.waitForServer(ros::Duration(60)));
    int tries = 0;
    while (run(client, goal("warm-up")).outcome != ScanResult::FINISHED)
      ASSERT_LT(++tries, 30);
  }

  void SetUp() override {
    node_.deleteParam("/fake");
    log_subscriber_ =
        node_.subscribe<std_msgs::String>("/fake/log", 100,
                                          boost::function<void(const std_msgs::StringConstPtr&)>(
                                              [this](const std_msgs::StringConstPtr& text) {
                                                const std::lock_guard<std::mutex> lock(mutex_);
                                                log_.push_back(text->data);
                                              }));
    while (log_subscriber_.getNumPublishers() == 0) {
      ASSERT_TRUE(ros::ok());
      ros::WallDuration(0.02).sleep();
    }
    ASSERT_TRUE(client_.waitForServer(ros::Duration(20)));
  }

  static scan_cell_msgs::ScanGoal goal(const std::string& scan_id) {
    scan_cell_msgs::ScanGoal goal;
    goal.scan_id = scan_id;
    goal.frame = "world";
    goal.passes.resize(1);
    scan_cell_msgs::ScanPass& line = goal.passes.front();
    line.kind = scan_cell_msgs::ScanPass::LINE;
    line.poses.resize(2);
    line.poses[0].orientation.x = line.poses[1].orientation.x = 1;
    line.poses[1].position.x = 0.1;
    line.speed = 0.1;
    line.rate = 50;
    line.lasers = scan_cell_msgs::ScanPass::LASER_0;
    return goal;
  }

  ScanResult run(const scan_cell_msgs::ScanGoal& scan) { return run(client_, scan); }

  static ScanResult run(Client& client, const scan_cell_msgs::ScanGoal& scan) {
    EXPECT_TRUE(client.sendGoalAndWait(scan, ros::Duration(60)).isDone());
    return *client.getResult();
  }

  /// Starts a scan and returns once frames arrive.
  static void start(Client& client, const scan_cell_msgs::ScanGoal& scan) {
    const auto come = std::make_shared<std::promise<void>>();
    const auto once = std::make_shared<std::once_flag>();
    client.sendGoal(scan, Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                    [=](const scan_cell_msgs::ScanFeedbackConstPtr& feedback) {
                      if (feedback->frames > 5) std::call_once(*once, [&] { come->set_value(); });
                    });
    ASSERT_EQ(come->get_future().wait_for(std::chrono::seconds(30)), std::future_status::ready);
  }

  /// Waits for a log line, which may arrive after the result.
  bool logged(const std::string& text) {
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(20);
    while (ros::WallTime::now() < deadline) {
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (std::find(log_.begin(), log_.end(), text) != log_.end()) return true;
      }
      ros::WallDuration(0.02).sleep();
    }
    return false;
  }

  ros::NodeHandle node_;
  Client client_{"/scan_cell/scan", false};
  std::mutex mutex_;
  std::vector<std::string> log_;
  ros::Subscriber log_subscriber_;  // last: its callback uses the log
};

}  // namespace scan_test
