// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The rules of c4g_protocol.md, sentence by sentence, asked on the wire.
#include <unistd.h>

#include "controller/arm/wire_pose.h"
#include "controller/bare_client.h"

using scan_cell_sim::Controller;
using scan_cell_sim::MotionStatus;

namespace {

constexpr int kStraggler = 5, kOutOfRange = 9, kJointLimit = 12, kSingular = 14, kOutOfTurn = 18;

class Rules : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(code(client_.open()), 0); }

  json ask(const json& request) { return client_.ask(++seq_, request); }
  json set(const std::string& name, const json& value) {
    return ask({{"cmd", "SET_PARAMETER"}, {"name", name}, {"value", value}});
  }
  json get(const std::string& name) {
    return ask({{"cmd", "GET_PARAMETER"}, {"name", name}})["value"];
  }
  json state() { return ask({{"cmd", "GET_STATIC_POSE"}})["state"]; }

  /// The state after a motion in joints.
  json state_at(const json& joints) {
    json answer = ask({{"cmd", "MOVE_JOINT"}, {"joints", joints}, {"camera_fps", 0}});
    EXPECT_EQ(code(answer), 0) << answer;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    json now = state();
    while (now["status"] == "moving" && std::chrono::steady_clock::now() < deadline) {
      usleep(10000);
      client_.drain();
      now = state();
    }
    EXPECT_EQ(now["status"], "arrived");
    return now;
  }

  Controller controller_{any_port()};
  BareClient client_{controller_.port()};
  std::uint64_t seq_ = 1;
};

json move_with_angles(double a, double e, double r) {
  return {{"cmd", "MOVE_CARTESIAN"}, {"pose", {800, 0, 600, a, e, r}}, {"camera_fps", 0}};
}

}  // namespace

TEST_F(Rules, AnglesAreSentInTheirRangesAndAIsZeroWhereItIsUndefined) {
  // straight down, the flange turned by J6 about what is then the base's z: R = 180 - J6
  for (const auto& [j6, r] : {std::pair{0, 180}, {30, 150}, {-30, -150}, {180, 0}, {-180, 0}}) {
    const json pose = state_at({0, 0, -90, 0, 90, j6})["pose"];
    EXPECT_EQ(pose[3], 0) << pose;
    EXPECT_EQ(pose[4], 180) << pose;
    EXPECT_EQ(pose[5], r) << pose;
  }
  // straight up: A = 0, E = 0
  const json up = state_at({0, 0, -90, 0, -90, 0})["pose"];
  EXPECT_EQ(up[3], 0) << up;
  EXPECT_EQ(up[4], 0) << up;
  EXPECT_EQ(up[5], 180) << up;
}

TEST_F(Rules, AnglesOfMinus180AreSentAs180) {
  // level to the front, x of the flange upwards
  const json front = state_at({0, 0, -90, 0, 0, 0})["pose"];
  EXPECT_EQ(front[3], 0) << front;
  EXPECT_EQ(front[4], 90) << front;
  EXPECT_EQ(front[5], 180) << front;
  for (const double nearly : {-179.99999, 179.99999, -180.0, 180.0}) {
    const auto shown =
        scan_cell_sim::shown(scan_cell_sim::pose_from_wire({0, 0, 0, nearly, 90, nearly}));
    EXPECT_EQ(shown[3], 180) << nearly;
    EXPECT_EQ(shown[5], 180) << nearly;
  }
  for (const double e : {0.0, 0.00003, 179.99997, 180.0}) {
    const auto shown = scan_cell_sim::shown(scan_cell_sim::pose_from_wire({0, 0, 0, 100, e, 100}));
    EXPECT_EQ(shown[3], 0) << e;
    EXPECT_EQ(shown[4], std::round(e)) << e;
    EXPECT_EQ(shown[5], e < 90 ? -160 : 0) << e;
  }
}

TEST_F(Rules, AnglesOutsideTheirRangesAreRefused) {
  for (const auto& [a, e, r] : {std::array{0.0, 190.0, 180.0},
                                {0.0, -0.001, 180.0},
                                {400.0, 180.0, 180.0},
                                {-180.001, 180.0, 180.0},
                                {0.0, 180.0, 180.001},
                                {0.0, 180.0, -400.0}}) {
    EXPECT_EQ(code(ask(move_with_angles(a, e, r))), kOutOfRange) << a << ' ' << e << ' ' << r;
    EXPECT_EQ(code(set("user_frame", {0, 0, 0, a, e, r})), kOutOfRange);
  }
  EXPECT_EQ(code(set("tool_frame", {0, 0, 0, 500, 0, 0})), kOutOfRange);
  EXPECT_EQ(code(set("base_frame", {100000.1, 0, 0, 0, 0, 0})), kOutOfRange);
  EXPECT_EQ(controller_.motions_begun(), 0u);
  for (const char* const frame : {"base_frame", "tool_frame", "user_frame"})
    EXPECT_EQ(get(frame), json({0, 0, 0, 0, 0, 0}));
}

TEST_F(Rules, EveryPairOfAnglesWithTheRightDifferenceIsTaken) {
  for (const auto& [a, r] : {std::pair{0, 180}, {90, -90}, {-180, 0}, {180, 0}, {-90, 90}}) {
    const json answer = ask(move_with_angles(a, 180, r));
    EXPECT_EQ(code(answer), 0) << a << ' ' << r;
    EXPECT_EQ(answer["state"]["pose"], json({800, 0, 600, 0, 180, 180})) << answer["state"];
    EXPECT_EQ(ask({{"cmd", "STOP"}})["state"]["pose"], json({800, 0, 600, 0, 180, 180}));
  }
}

TEST_F(Rules, JointsBeyondTheirRangesAreNamedHoweverFar) {
  for (const double joint : {210.1, -1e7, 1e300}) {
    const json answer =
        ask({{"cmd", "MOVE_JOINT"}, {"joints", {0, 0, -90, joint, 90, 0}}, {"camera_fps", 0}});
    EXPECT_EQ(code(answer), kJointLimit);
    EXPECT_EQ(answer["error"]["text"].get<std::string>().find("J4 "), 0u) << answer["error"];
  }
}

TEST_F(Rules, ALineThroughTheStraightWristIsRefused) {
  state_at({0, 0, -90, 0, 45, 0});
  // by hand: J5 = -45 lifts the flange by 45 degrees over the level forearm
  const double reach = 150 + 647.07 + 95 * std::sqrt(0.5);
  const double height = 450 + 590 + 130 + 95 * std::sqrt(0.5);
  const json through = {
      {"cmd", "MOVE_CARTESIAN"}, {"pose", {reach, 0, height, 0, 45, 180}}, {"camera_fps", 0}};
  EXPECT_EQ(code(ask(through)), kSingular);
  EXPECT_EQ(controller_.motions_begun(), 1u);
  EXPECT_EQ(code(set("motion_type", "joint")), 0);
  EXPECT_EQ(code(ask(through)), 0);
}

TEST_F(Rules, WhatIsSetReadsBackAsItWasSet) {
  for (const double value : {60.0, 7.0, 29.0, 57.3, 0.07, 33.333333333333336}) {
    for (const char* const name : {"override", "linear_speed", "rotational_speed"}) {
      if (value < 1 && std::string(name) == "rotational_speed") continue;
      EXPECT_EQ(code(set(name, value)), 0);
      EXPECT_EQ(get(name), value) << name;
    }
    EXPECT_EQ(state()["override"], value);
    EXPECT_EQ(state()["linear_speed"], value);
  }
  const json frame = {500, 0.1, -100, 0, 33.3, 90};
  EXPECT_EQ(code(set("user_frame", frame)), 0);
  EXPECT_EQ(get("user_frame").dump(), frame.dump());
}

TEST_F(Rules, ParametersBeginWithTheirDefaultsAndTheRobotsOwnNumbers) {
  const json expected = {{"motion_type", "linear"},
                         {"interpolation", "linear"},
                         {"override", 100},
                         {"linear_speed", 250},
                         {"linear_acceleration", 1000},
                         {"rotational_speed", 60},
                         {"stream_period", 4},
                         {"base_frame", {0, 0, 0, 0, 0, 0}},
                         {"joint_lower", {-170, -85, -170, -210, -130, -2700}},
                         {"joint_upper", {170, 155, 0, 210, 130, 2700}},
                         {"joint_speed", {140, 160, 170, 450, 375, 550}}};
  for (const auto& [name, value] : expected.items())
    EXPECT_EQ(get(name), value) << name;
  EXPECT_EQ(state()["linear_speed"], 250);
}

TEST_F(Rules, ARequestOutOfTurnIsRefusedAndSpoilsNoLaterOne) {
  for (const std::uint64_t seq :
       {std::uint64_t{3}, std::uint64_t{1000}, std::uint64_t{1} << 63, UINT64_MAX})
    EXPECT_EQ(code(client_.ask(seq, move_to(800, 100, 600))), kOutOfTurn) << seq;
  EXPECT_EQ(controller_.motions_begun(), 0u);
  EXPECT_EQ(code(client_.ask(2, {{"cmd", "STOP"}})), 0);
  EXPECT_EQ(code(client_.ask(3, {{"cmd", "STOP"}})), 0);
  EXPECT_EQ(code(client_.ask(2, {{"cmd", "STOP"}})), kStraggler);
  EXPECT_EQ(code(client_.ask(0, {{"cmd", "STOP"}})), kStraggler);
  EXPECT_EQ(code(client_.ask(4, {{"cmd", "STOP"}})), 0);
}

TEST_F(Rules, ARefusedRequestHasItsNumberAllTheSame) {
  EXPECT_EQ(code(client_.ask(2, {{"cmd", 7}})), 1);
  EXPECT_EQ(code(client_.ask(3, {{"command", "STOP"}})), 1);
  EXPECT_EQ(code(client_.ask(4, {{"cmd", "DANCE"}})), 6);
  json other_version = {{"c4g", 2}, {"session", 100}, {"seq", 5}, {"cmd", "STOP"}};
  client_.send(other_version);
  EXPECT_EQ(code(client_.receive("ack")), 2);
  other_version.update({{"c4g", "1"}, {"seq", 6}});
  client_.send(other_version);
  EXPECT_EQ(code(client_.receive("ack")), 1);
  EXPECT_EQ(code(client_.ask(7, {{"cmd", "STOP"}})), 0);
}

TEST_F(Rules, OpenHasTheFirstNumberOfItsSession) {
  EXPECT_EQ(code(client_.ask(2, move_to(800, 300, 600))), 0);
  EXPECT_EQ(code(client_.ask(3, {{"cmd", "OPEN"}})), kOutOfTurn) << "it is open already";
  EXPECT_EQ(code(client_.ask(1, {{"cmd", "OPEN"}})), kStraggler);
  EXPECT_EQ(code(client_.ask(7, {{"cmd", "OPEN"}}, 101)), kOutOfTurn);
  EXPECT_EQ(controller_.state().status, MotionStatus::kMoving) << "none of them opened a session";
  EXPECT_EQ(code(client_.ask(1, {{"cmd", "OPEN"}}, 101)), 0);
}

TEST_F(Rules, NoSessionThatEndedIsOpenedAgainThoughOthersWereThereSince) {
  EXPECT_EQ(code(ask({{"cmd", "CLOSE"}})), 0);
  BareClient other(controller_.port());
  EXPECT_EQ(code(other.open(5)), 0);
  EXPECT_EQ(code(other.ask(2, {{"cmd", "CLOSE"}}, 5)), 0);
  EXPECT_EQ(code(client_.open(100)), 3);
  EXPECT_EQ(code(client_.open(101)), 0);
  EXPECT_EQ(code(client_.ask(2, {{"cmd", "CLOSE"}}, 101)), 0);
  EXPECT_EQ(code(other.open(5)), 3);
}

TEST_F(Rules, ARefusedMotionIsNotStreamed) {
  EXPECT_EQ(code(ask(move_to(2500, 0, 600))), 13);
  EXPECT_TRUE(client_.receive(100).is_null());
  EXPECT_EQ(code(ask(move_to(800, 0, 600))), 0);
  EXPECT_FALSE(client_.receive("state").is_null()) << "the shortest motion is streamed";
}
