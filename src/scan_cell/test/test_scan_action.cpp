// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <actionlib/client/simple_action_client.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <scan_cell_msgs/CellState.h>
#include <scan_cell_msgs/MoveAction.h>
#include <scan_cell_msgs/ScanAction.h>
#include <std_msgs/String.h>

#include <boost/asio.hpp>
#include <chrono>
#include <future>
#include <mutex>
#include <vector>

#include "scan_cell/videe_command.h"

using scan_cell_msgs::ScanResult;
using State = actionlib::SimpleClientGoalState;

namespace {

class ScanAction : public testing::Test {
 protected:
  using Client = actionlib::SimpleActionClient<scan_cell_msgs::ScanAction>;

  void SetUp() override {
    node_.setParam("/fake/silent", "");
    node_.setParam("/fake/missing", 0);
    log_subscriber_ =
        node_.subscribe<std_msgs::String>("/fake/log", 100,
                                          boost::function<void(const std_msgs::StringConstPtr&)>(
                                              [this](const std_msgs::StringConstPtr& text) {
                                                const std::lock_guard<std::mutex> lock(mutex_);
                                                log_.push_back(text->data);
                                              }));
    ASSERT_TRUE(client_.waitForServer(ros::Duration(20)));
    actionlib::SimpleActionClient<scan_cell_msgs::MoveAction> robot("/c4g_driver/move", false);
    ASSERT_TRUE(robot.waitForServer(ros::Duration(20)));
  }

  static scan_cell_msgs::ScanGoal goal(const std::string& scan_id) {
    scan_cell_msgs::ScanGoal goal;
    goal.scan_id = scan_id;
    goal.start.header.frame_id = goal.end.header.frame_id = "world";
    goal.start.pose.orientation.x = goal.end.pose.orientation.x = 1;
    goal.end.pose.position.x = 0.1;
    goal.speed = 0.1;
    goal.rate = 50;
    goal.lasers = 1;
    return goal;
  }

  ScanResult run(const scan_cell_msgs::ScanGoal& scan) {
    EXPECT_TRUE(client_.sendGoalAndWait(scan, ros::Duration(30)).isDone());
    return *client_.getResult();
  }

  /// Waits for it: the log may come after the result.
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
  ros::Subscriber log_subscriber_;
  std::mutex mutex_;
  std::vector<std::string> log_;
};

}  // namespace

TEST_F(ScanAction, FinishesAndGivesAuditAndCloud) {
  const ScanResult result = run(goal("whole"));
  EXPECT_EQ(client_.getState().state_, State::SUCCEEDED) << result.message;
  EXPECT_EQ(result.outcome, ScanResult::FINISHED);
  EXPECT_EQ(result.scan_id, "whole");
  EXPECT_GT(result.audit.triggers, 10U);
  EXPECT_EQ(result.statistics.points, result.audit.triggers);
  EXPECT_FALSE(result.cloud.data.empty());
  EXPECT_EQ(result.message, "0 events missing") << "what the binder says must not be lost";
}

TEST_F(ScanAction, FailsAndKeepsTheDataWhereTriggerEventsAreMissing) {
  node_.setParam("/fake/missing", 3);
  const ScanResult result = run(goal("events missing"));
  EXPECT_EQ(result.outcome, ScanResult::STAGE_FAILED);
  EXPECT_NE(result.message.find("3 events missing"), std::string::npos) << result.message;
  EXPECT_EQ(result.audit.triggers_missing, 3U);
  EXPECT_EQ(result.statistics.points, result.audit.triggers - 3);
  EXPECT_FALSE(result.cloud.data.empty());
}

TEST_F(ScanAction, RejectsASecondScanByTheNameOfTheFirst) {
  client_.sendGoal(goal("first"));
  Client second("/scan_cell/scan", false);
  ASSERT_TRUE(second.waitForServer(ros::Duration(20)));
  second.sendGoalAndWait(goal("second"), ros::Duration(10));
  EXPECT_EQ(second.getState().state_, State::REJECTED);
  EXPECT_NE(second.getResult()->message.find("'first' is running"), std::string::npos);
  ASSERT_TRUE(client_.waitForResult(ros::Duration(30)));
  EXPECT_EQ(client_.getState().state_, State::SUCCEEDED) << "the first goes on";
}

TEST_F(ScanAction, StopsTheRobotAndKeepsTheDataWhenCancelled) {
  std::promise<void> frames_come;
  bool waiting = true;
  client_.sendGoal(goal("cancelled"), Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                   [&](const scan_cell_msgs::ScanFeedbackConstPtr& feedback) {
                     if (waiting && feedback->frames > 5) frames_come.set_value();
                     if (feedback->frames > 5) waiting = false;
                   });
  ASSERT_EQ(frames_come.get_future().wait_for(std::chrono::seconds(30)), std::future_status::ready);
  client_.cancelGoal();
  ASSERT_TRUE(client_.waitForResult(ros::Duration(10)));
  EXPECT_EQ(client_.getState().state_, State::PREEMPTED);
  EXPECT_EQ(client_.getResult()->outcome, ScanResult::CANCELLED);
  EXPECT_TRUE(logged("disarmed"));
  EXPECT_TRUE(logged("stopped"));
  EXPECT_FALSE(client_.getResult()->cloud.data.empty());
}

TEST_F(ScanAction, EndsWhenTheRobotTellsAnOldPose) {
  node_.setParam("/fake/silent", "pose");
  const ScanResult result = run(goal("old pose"));
  EXPECT_EQ(result.outcome, ScanResult::ROBOT_LOST) << result.message;
  EXPECT_NE(result.message.find("no new pose"), std::string::npos) << result.message;
  EXPECT_TRUE(logged("disarmed"));
}

TEST_F(ScanAction, EndsWithTheReasonWhenADeviceFallsSilent) {
  const std::vector<std::pair<std::string, int>> devices = {{"robot", ScanResult::ROBOT_LOST},
                                                            {"camera", ScanResult::CAMERA_LOST},
                                                            {"trigger", ScanResult::TRIGGER_LOST}};
  for (const auto& [device, outcome] : devices) {
    node_.setParam("/fake/silent", device);
    const ScanResult result = run(goal(device));
    EXPECT_EQ(result.outcome, outcome) << result.message;
    EXPECT_EQ(client_.getState().state_, State::ABORTED);
    EXPECT_EQ(result.message.find(device), 0U) << result.message;
    EXPECT_FALSE(result.cloud.data.empty());
  }
}

TEST_F(ScanAction, RefusesWhatMakesNoSense) {
  scan_cell_msgs::ScanGoal bad = goal("bad");
  bad.start.header.frame_id = "no_such_frame";
  EXPECT_NE(run(bad).message.find("no_such_frame"), std::string::npos);
  EXPECT_EQ(client_.getState().state_, State::REJECTED);
  bad = goal("bad");
  bad.start.pose.orientation.x = 0;
  EXPECT_NE(run(bad).message.find("quaternion"), std::string::npos);
  bad = goal("bad");
  bad.speed = 9;
  EXPECT_NE(run(bad).message.find("speed"), std::string::npos);
}

TEST_F(ScanAction, IsReachedByViDeE) {
  boost::asio::io_context context;
  boost::asio::ip::tcp::socket socket(context);
  boost::system::error_code error = boost::asio::error::not_connected;
  for (int i = 0; i < 400 && error; ++i) {  // until videe_node listens
    ros::WallDuration(0.05).sleep();
    socket.close();
    socket.connect({boost::asio::ip::make_address("127.0.0.1"), 5999}, error);
  }
  ASSERT_FALSE(error) << error.message();
  boost::asio::streambuf buffer;
  const auto ask = [&](const std::string& command) {
    boost::asio::write(socket, boost::asio::buffer(command + "\n"));
    boost::asio::read_until(socket, buffer, '\n');
    std::istream stream(&buffer);
    std::string line;
    std::getline(stream, line);
    return line;
  };
  EXPECT_EQ(ask("INIT_CYCLE"), "OK");
  EXPECT_EQ(ask("START_SCAN").substr(0, 5), "ERROR");
  EXPECT_EQ(ask("SET_POSITION 0,0,600,180,0,0 100,0,600,180,0,0"), "OK");
  EXPECT_EQ(ask("START_SCAN"), "OK");
  const std::string result = ask("STOP_SCAN");
  EXPECT_EQ(result.substr(0, 8), "OK scan=") << result;
  EXPECT_EQ(ask("STOP_SCAN").substr(0, 5), "ERROR");
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_scan_action");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
