// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <scan_cell_msgs/DisarmTrigger.h>

#include <atomic>
#include <future>
#include <string>

#include "scan_cell/ros/service_call.h"

using scan_cell::ask;
using scan_cell_msgs::DisarmTrigger;

namespace {

constexpr double kTimeout = 30;  // [s] far more than any call takes

std::string complaint_of_ask(double timeout) {
  try {
    ask<DisarmTrigger>("/service", {}, timeout);
  } catch (const scan_cell_common::ConnectionError& error) {
    return error.what();
  }
  return "";
}

class AServiceCall : public testing::Test {
 protected:
  using Request = DisarmTrigger::Request;
  using Response = DisarmTrigger::Response;
  using Answer = boost::function<bool(Request&, Response&)>;

  void serve(const Answer& answer) { server_ = node_.advertiseService("/service", answer); }

  ros::NodeHandle node_;
  std::atomic<int> calls_{0};
  ros::ServiceServer server_;  // goes first: its calls may still be under way
};

TEST_F(AServiceCall, GivesTheAnswer) {
  serve([this](Request&, Response& response) {
    response.message = "call " + std::to_string(++calls_);
    return true;
  });
  for (int call = 1; call <= 100; ++call)
    ASSERT_EQ(ask<DisarmTrigger>("/service", {}, kTimeout).message, "call " + std::to_string(call));
}

TEST_F(AServiceCall, IsNotRepeatedIfItsAnswerIsLost) {
  serve([this](Request&, Response&) {
    ++calls_;
    return false;  // as for a connection lost after the service acted: roscpp says no more
  });
  EXPECT_NE(complaint_of_ask(kTimeout).find("connection lost"), std::string::npos);
  EXPECT_EQ(calls_, 1);
}

TEST_F(AServiceCall, SaysThatThereIsNoSuchService) {
  EXPECT_NE(complaint_of_ask(kTimeout).find("no such service"), std::string::npos);
}

TEST_F(AServiceCall, DoesNotWaitForAServiceThatHangs) {
  std::promise<void> over;
  serve([until = over.get_future().share()](Request&, Response&) {
    until.wait();
    return true;
  });
  EXPECT_NE(complaint_of_ask(0.2).find("no answer within 0.2 s"), std::string::npos);
  over.set_value();
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_service_call");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
