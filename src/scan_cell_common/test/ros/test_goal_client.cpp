// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <actionlib/TestAction.h>
#include <actionlib/server/action_server.h>
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <atomic>
#include <deque>
#include <functional>
#include <mutex>
#include <stdexcept>

#include "scan_cell_common/ros/goal_client.h"

using actionlib::TerminalState;
using actionlib::TestAction;
using scan_cell_common::ConnectionError;

namespace {

constexpr double kTimeout = 30;   // [s] far more than any step takes
constexpr double kShort = 0.2;    // [s] for what must not happen
constexpr int kThreads = 4;       // threads that serve callbacks
constexpr int kRacedGoals = 500;  // in a few of 100 the answer came before sendGoal() returned

/// A server that does with a goal what a test says, beside its client, with several threads.
class GoalClient : public testing::Test {
 protected:
  using Server = actionlib::ActionServer<TestAction>;
  using Client = scan_cell_common::GoalClient<TestAction>;
  using Goal = Server::GoalHandle;

  void SetUp() override {
    spinner_.start();
    server_.start();
    ASSERT_TRUE(client_.wait_for_server(kTimeout));
  }

  void TearDown() override { spinner_.stop(); }

  static actionlib::TestGoal numbered(int number) {
    actionlib::TestGoal goal;
    goal.goal = number;
    return goal;
  }

  static actionlib::TestResult result_of(Goal& goal) {
    actionlib::TestResult result;
    result.result = goal.getGoal()->goal;
    return result;
  }

  static void reject(Goal& goal) { goal.setRejected(result_of(goal), "no"); }

  static void accept(Goal& goal) { goal.setAccepted(); }

  static void succeed(Goal& goal) { goal.setSucceeded(result_of(goal)); }

  void on_goal(Goal goal) {
    const std::lock_guard<std::mutex> lock(mutex_);
    goals_.push_back(goal);
    do_(goals_.back());
  }

  void on_cancel(Goal goal) { goal.setCanceled(result_of(goal)); }

  Goal& goal(std::size_t index) {
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kTimeout);
    for (;; ros::WallDuration(0.005).sleep()) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (goals_.size() > index) return goals_[index];
      if (ros::WallTime::now() > deadline) throw std::runtime_error("the goal did not come");
    }
  }

  ros::NodeHandle node_;
  std::mutex mutex_;
  std::deque<Goal> goals_;
  std::function<void(Goal&)> do_ = accept;
  ros::AsyncSpinner spinner_{kThreads};
  Server server_{node_, "work", [this](Goal goal) { on_goal(goal); },
                 [this](Goal goal) { on_cancel(goal); }, false};
  Client client_{node_, "work"};
};

}  // namespace

TEST_F(GoalClient, HearsAnAnswerThatComesWhileTheGoalIsBeingSent) {
  do_ = reject;
  for (int number = 1; number <= kRacedGoals; ++number) {
    std::atomic<int> told{0};
    client_.send(numbered(number), [&](const auto& end) { told = end.result->result; });
    const auto end = client_.wait_for_end(kTimeout);
    ASSERT_TRUE(end) << number;
    ASSERT_EQ(end->state, TerminalState::REJECTED);
    ASSERT_EQ(end->state.getText(), "no");
    ASSERT_EQ(end->result->result, number);
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kTimeout);
    while (told != number && ros::WallTime::now() < deadline)
      ros::WallDuration(1e-4).sleep();
    ASSERT_EQ(told, number);
  }
}

TEST_F(GoalClient, TellsNothingMoreOfTheGoalBefore) {
  std::atomic<bool> told{false};
  client_.send(numbered(1), [&](const auto&) { told = true; });
  goal(0);
  client_.wait_until_taken(kTimeout);
  client_.send(numbered(2));
  EXPECT_FALSE(client_.end());
  succeed(goal(0));
  succeed(goal(1));
  const auto end = client_.wait_for_end(kTimeout);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->result->result, 2);
  EXPECT_FALSE(told);
}

TEST_F(GoalClient, GivesUpAGoalThatIsNotTakenAndHasItCancelled) {
  do_ = [](Goal&) {};
  client_.send(numbered(1));
  EXPECT_THROW(client_.wait_until_taken(kShort), ConnectionError);
  const auto end = client_.wait_for_end(kTimeout);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->state, TerminalState::RECALLED);
}

TEST_F(GoalClient, HandsOnFeedbackOfTheGoalUnderWayOnly) {
  std::atomic<int> heard{0};
  client_.send(numbered(1), {}, [&](const auto& feedback) { heard = feedback.feedback; });
  client_.wait_until_taken(kTimeout);
  actionlib::TestFeedback feedback;
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kTimeout);
  for (feedback.feedback = 7; heard != 7 && ros::WallTime::now() < deadline;
       ros::WallDuration(0.01).sleep())
    goal(0).publishFeedback(feedback);
  EXPECT_EQ(heard, 7);
  client_.send(numbered(2));
  client_.wait_until_taken(kTimeout);
  feedback.feedback = 8;
  goal(0).publishFeedback(feedback);
  succeed(goal(1));
  EXPECT_TRUE(client_.wait_for_end(kTimeout));
  EXPECT_EQ(heard, 7);
}

TEST_F(GoalClient, CancelsTheGoalUnderWay) {
  client_.cancel();  // none: does nothing
  client_.send(numbered(1));
  client_.wait_until_taken(kTimeout);
  client_.cancel();
  const auto end = client_.wait_for_end(kTimeout);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->state, TerminalState::PREEMPTED);
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_goal_client");
  const ros::NodeHandle node;  // keeps ROS alive between tests
  return RUN_ALL_TESTS();
}
