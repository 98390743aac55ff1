// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The controller's faults, set by the simulator's service and seen on the wire.
#include <ros/ros.h>
#include <scan_cell_msgs/SetFaults.h>

#include "controller/bare_client.h"
#include "node/set_faults.h"

using scan_cell_msgs::SetFaults;

namespace {

template <class Field, class Value>
SetFaults::Request with(Field field, const Value& value) {
  SetFaults::Request request;
  request.*field = value;
  return request;
}

class RobotFaults : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(set_faults({}).success);
    ASSERT_EQ(code(client_.open()), 0);
  }
  void TearDown() override {
    client_.drain();
    client_.ask(++seq_, {{"cmd", "CLOSE"}});
    EXPECT_TRUE(set_faults({}).success);
  }

  json ask(const json& request) { return client_.ask(++seq_, request); }
  json state() { return ask({{"cmd", "GET_STATIC_POSE"}})["state"]; }

  /// The answer to a request that is repeated until there is one.
  json answer_at_last(json request) {
    request.update({{"c4g", 1}, {"session", 100}, {"seq", ++seq_}});
    json answer = nullptr;
    for (int i = 0; i < 1000 && answer.is_null(); ++i) {
      client_.send(request);
      answer = client_.receive("ack", 20);
    }
    return answer;
  }

  std::uint64_t seq_ = 1;
  BareClient client_{5410};
};

}  // namespace

TEST_F(RobotFaults, SelectTheModeAndTheDrives) {
  ASSERT_TRUE(set_faults(with(&SetFaults::Request::robot_mode, std::string("automatic"))).success);
  EXPECT_EQ(state()["mode"], "automatic");
  EXPECT_EQ(code(ask(move_to(800, 5, 600))), 16);
  auto programming = with(&SetFaults::Request::robot_mode, std::string("programming"));
  programming.robot_drives_off = true;
  ASSERT_TRUE(set_faults(programming).success);
  EXPECT_EQ(code(ask(move_to(800, 5, 600))), 11);
  programming.robot_drives_off = false;
  ASSERT_TRUE(set_faults(programming).success);
  EXPECT_EQ(state()["drives"], true);
}

TEST_F(RobotFaults, PressTheEmergencyStopAndMakeAllWellAgain) {
  ASSERT_TRUE(set_faults(with(&SetFaults::Request::robot_e_stop, true)).success);
  EXPECT_EQ(state()["e_stop"], true);
  EXPECT_EQ(code(ask(move_to(800, 5, 600))), 11);
  const std::string text = "following error of J2";
  ASSERT_TRUE(set_faults(with(&SetFaults::Request::robot_motion_error, text)).success);
  EXPECT_EQ(state()["alarms"][0]["text"], text);
  ASSERT_TRUE(set_faults({}).success);
  EXPECT_EQ(state()["alarms"], json::array());
  EXPECT_EQ(code(ask({{"cmd", "STOP"}})), 0);
}

TEST_F(RobotFaults, KeepItSilentOrDeafForAWhile) {
  for (const auto field :
       {&SetFaults::Request::robot_silence, &SetFaults::Request::robot_deafness}) {
    const auto start = std::chrono::steady_clock::now();
    ASSERT_TRUE(set_faults(with(field, 0.3)).success);
    EXPECT_EQ(code(answer_at_last({{"cmd", "STOP"}})), 0);
    EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(290));
    client_.drain();
  }
}

TEST_F(RobotFaults, RestartIt) {
  ASSERT_TRUE(set_faults(with(&SetFaults::Request::robot_restart, 0.2)).success);
  EXPECT_EQ(code(answer_at_last({{"cmd", "STOP"}})), 3);
}

TEST_F(RobotFaults, SpoilRequestsTooWhereThatIsAsked) {
  auto faults = with(&SetFaults::Request::robot_lost_packets, 1.0);
  faults.robot_requests_too = true;
  ASSERT_TRUE(set_faults(faults).success);
  client_.send(json{{"c4g", 1}, {"session", 100}, {"seq", seq_ + 1}, {"cmd", "STOP"}});
  EXPECT_TRUE(client_.receive("ack", 300).is_null());
  ASSERT_TRUE(set_faults({}).success);
  EXPECT_EQ(code(ask({{"cmd", "STOP"}})), 0);
}

TEST_F(RobotFaults, AreRefusedByNameWhereTheyMakeNoSense) {
  const auto refused = [](const SetFaults::Request& request, const std::string& name) {
    const auto response = set_faults(request);
    EXPECT_FALSE(response.success) << name;
    EXPECT_EQ(response.message.find(name), 0u) << response.message;
  };
  refused(with(&SetFaults::Request::robot_mode, std::string("fast")), "robot_mode");
  refused(with(&SetFaults::Request::robot_lost_packets, 1.5), "robot_lost_packets");
  refused(with(&SetFaults::Request::robot_flipped, 2.0), "robot_flipped");
  refused(with(&SetFaults::Request::robot_jitter, -1.0), "robot_jitter");
  refused(with(&SetFaults::Request::robot_restart, -1.0), "robot_restart");
  refused(with(&SetFaults::Request::robot_deafness, -1.0), "robot_deafness");
  refused(with(&SetFaults::Request::robot_clock_drift, 0.2), "robot_clock_drift");
}
