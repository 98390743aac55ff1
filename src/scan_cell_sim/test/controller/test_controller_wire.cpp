// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The controller on its real wire, with requests written out by hand.
#include <gtest/gtest.h>
#include <unistd.h>

#include <set>

#include "controller/bare_client.h"
#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/errors/errors.h"

using nlohmann::json;
using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;
using scan_cell_sim::Controller;
using scan_cell_sim::ControllerFaults;
using scan_cell_sim::ControllerMode;
using scan_cell_sim::ControllerOptions;
using scan_cell_sim::MotionStatus;

namespace {

class Wire : public testing::Test {
 protected:
  /// States until the first in which the robot stands still.
  std::vector<json> stream_until_still(BareClient& client) {
    std::vector<json> states;
    while (true) {
      const json state = client.receive("state");
      if (state.is_null()) return states;
      states.push_back(state);
      if (state["status"] != "moving") return states;
    }
  }

  Controller controller_{any_port()};
  BareClient client_{controller_.port()};
};

}  // namespace

TEST_F(Wire, TellsItsStartPosture) {
  const json ack = client_.open();
  EXPECT_EQ(code(ack), 0);
  const json state = ack["state"];
  EXPECT_EQ(state["status"], "idle");
  EXPECT_NEAR(state["pose"][0].get<double>(), 800, 1e-9);
  EXPECT_NEAR(state["pose"][1].get<double>(), 0, 1e-9);
  EXPECT_NEAR(state["pose"][2].get<double>(), 600, 1e-9);
  EXPECT_NEAR(state["pose"][4].get<double>(), 180, 1e-9);
  EXPECT_EQ(state["mode"], "remote");
  EXPECT_EQ(state["alarms"], json::array());
  EXPECT_EQ(state["drives"], true);
}

TEST_F(Wire, StreamsTheTruePoseAtTheInstantItTells) {
  const Nanoseconds before = host_now();
  const json opened = client_.open();
  const Nanoseconds after = host_now();
  EXPECT_EQ(code(client_.ask(2, move_to(800, 100, 600))), 0);
  const std::vector<json> states = stream_until_still(client_);
  ASSERT_GT(states.size(), 30u);  // 0.65 s at 4 ms make 162; a busy machine skips some
  EXPECT_EQ(states.back()["status"], "arrived");
  EXPECT_EQ(states.back()["motion"], 2);
  EXPECT_EQ(states.back()["camera_fps"], 100);
  // the controller's clock differs from the host's by a constant that the first answer confines
  const Nanoseconds opened_at = opened["state"]["t"].get<Nanoseconds>() * 1000;
  double worst = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Nanoseconds t = states[i]["t"].get<Nanoseconds>() * 1000;
    const double y = states[i]["pose"][1].get<double>() * 1e-3;
    const double earliest = controller_.flange_at(before + t - opened_at).translation().y();
    const double latest = controller_.flange_at(after + t - opened_at).translation().y();
    worst = std::max({worst, earliest - y, y - latest});
    EXPECT_EQ(states[i]["n"].get<std::size_t>(), i + 1);
  }
  EXPECT_LT(worst, 1e-6);
}

TEST_F(Wire, CarriesARepeatedMoveOutOnce) {
  const std::vector<json> moves = {
      move_to(800, 20, 600),
      move_through({810, 30, 600, 0, 180, 180}, 800, 40, 600),
      {{"cmd", "MOVE_JOINT"}, {"joints", {0, 8, -124, 0, 48, 0}}, {"camera_fps", 0}}};
  client_.open();
  std::uint64_t seq = 1;
  for (const json& move : moves) {
    const json first = client_.ask(++seq, move);
    EXPECT_EQ(code(first), 0) << first;
    EXPECT_EQ(client_.ask(seq, move), first);
    stream_until_still(client_);
    EXPECT_EQ(client_.ask(seq, move), first);
    EXPECT_EQ(controller_.motions_begun(), seq - 1);
    client_.drain();
    EXPECT_EQ(code(client_.ask(seq - 1, move)), 5) << "a straggler";
    EXPECT_EQ(controller_.motions_begun(), seq - 1);
  }
}

TEST_F(Wire, StopsAndForgetsTheMotionOfAnOldSession) {
  client_.open(100);
  client_.ask(2, move_to(800, 300, 600), 100);
  const json opened = client_.open(101);
  EXPECT_EQ(opened["state"]["motion"], 0);
  EXPECT_EQ(code(client_.ask(3, move_to(800, 300, 600), 100)), 3);
  EXPECT_EQ(controller_.motions_begun(), 1u);
  stream_until_still(client_);
  EXPECT_LT(controller_.state().flange.translation().y(), 0.25);
}

TEST_F(Wire, OpensNoSessionOfAClientAgainThatEnded) {
  client_.open(100);
  EXPECT_EQ(code(client_.ask(2, {{"cmd", "CLOSE"}})), 0);
  EXPECT_EQ(code(client_.open(100)), 3) << "late on the wire";
  EXPECT_EQ(code(client_.ask(2, move_to(800, 100, 600), 100)), 3);
  EXPECT_EQ(controller_.motions_begun(), 0u);
  EXPECT_EQ(code(client_.open(101)), 0);
}

TEST_F(Wire, ServesOneClientAtATime) {
  BareClient other(controller_.port());
  client_.open(100);
  EXPECT_EQ(code(other.open(200)), 4);
  EXPECT_EQ(code(other.ask(2, move_to(800, 100, 600), 100)), 4) << "a session is not a password";
  EXPECT_EQ(code(client_.ask(2, {{"cmd", "CLOSE"}})), 0);
  EXPECT_EQ(code(other.open(200)), 0);
}

TEST_F(Wire, StopsWhenItsClientGoesSilent) {
  client_.open();
  client_.ask(2, move_to(800, 350, 600));  // takes 1.65 s
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (controller_.state().status == MotionStatus::kMoving &&
         std::chrono::steady_clock::now() < deadline)
    usleep(10000);
  EXPECT_EQ(controller_.state().status, MotionStatus::kStopped);
  EXPECT_LT(controller_.state().flange.translation().y(), 0.34);
  client_.drain();
  EXPECT_EQ(code(client_.ask(3, {{"cmd", "STOP"}})), 3);
}

TEST_F(Wire, AnswersEveryMistakeWithItsCode) {
  client_.open();
  std::uint64_t seq = 1;
  const auto asked = [&](const json& request) { return code(client_.ask(++seq, request)); };
  EXPECT_EQ(asked({{"cmd", "DANCE"}}), 6);
  EXPECT_EQ(asked({{"cmd", "MOVE_CARTESIAN"}, {"pose", {1, 2, 3}}, {"camera_fps", 0}}), 1);
  EXPECT_EQ(asked({{"cmd", "MOVE_CARTESIAN"}, {"camera_fps", 0}}), 1);
  EXPECT_EQ(asked(move_to(2500, 0, 600)), 13);
  EXPECT_EQ(asked({{"cmd", "MOVE_JOINT"}, {"joints", {0, 0, 5, 0, 90, 0}}, {"camera_fps", 0}}), 12);
  const auto through = [](double x, double y, double e) {
    return move_through({x, y, 600, 0, e, 180}, 800, 100, 600);
  };
  EXPECT_EQ(asked(through(800, 50, 180)), 19) << "on a line";
  EXPECT_EQ(asked(through(800, 100, 180)), 19) << "the same place";
  EXPECT_EQ(asked(through(850, 50, 181)), 9);
  EXPECT_EQ(asked(through(1700, 50, 180)), 13);
  EXPECT_EQ(asked({{"cmd", "MOVE_CIRCULAR"}, {"pose", {800, 100, 600, 0, 180, 180}}}), 1);
  EXPECT_EQ(asked({{"cmd", "SET_OVERRIDE"}, {"override", 101}}), 9);
  EXPECT_EQ(asked({{"cmd", "SET_OVERRIDE"}, {"override", "half"}}), 1);
  EXPECT_EQ(asked({{"cmd", "SET_LINSPEED"}, {"linear_speed", 0}}), 9);
  EXPECT_EQ(asked({{"cmd", "GET_PARAMETER"}, {"name", "weather"}}), 7);
  EXPECT_EQ(asked({{"cmd", "SET_PARAMETER"}, {"name", "model"}, {"value", "x"}}), 8);
  EXPECT_EQ(asked({{"cmd", "SET_PARAMETER"}, {"name", "motion_type"}, {"value", "circular"}}), 9);
  EXPECT_EQ(controller_.motions_begun(), 0u);
  EXPECT_EQ(asked(move_to(800, 300, 600)), 0);
  EXPECT_EQ(asked(move_to(800, 0, 600)), 10);
  controller_.press_e_stop();
  stream_until_still(client_);
  EXPECT_EQ(asked(move_to(800, 0, 600)), 11);
}

TEST_F(Wire, TakesMotionsAsItsModeAllows) {
  client_.open();
  const json short_way = move_to(800, 5, 600);
  controller_.select(ControllerMode::kAutomatic);
  controller_.switch_drives(true);
  EXPECT_EQ(client_.ask(2, {{"cmd", "GET_STATIC_POSE"}})["state"]["mode"], "automatic");
  EXPECT_EQ(code(client_.ask(3, short_way)), 16);
  controller_.select(ControllerMode::kProgramming);
  EXPECT_EQ(code(client_.ask(4, short_way)), 11) << "nobody holds the enabling device";
  EXPECT_EQ(code(client_.ask(5, {{"cmd", "SET_DRIVES"}, {"drives", true}})), 16);
  controller_.switch_drives(true);
  EXPECT_EQ(client_.ask(6, {{"cmd", "GET_STATIC_POSE"}})["state"]["mode"], "programming");
  EXPECT_EQ(code(client_.ask(7, short_way)), 0);
}

TEST_F(Wire, LetsAClientInModeRemoteResetAlarmsAndSwitchTheDrives) {
  client_.open();
  const json reset = {{"cmd", "RESET_ALARMS"}};
  const auto drives = [](bool on) { return json{{"cmd", "SET_DRIVES"}, {"drives", on}}; };
  controller_.press_e_stop();
  EXPECT_EQ(code(client_.ask(2, reset)), 11);
  EXPECT_EQ(code(client_.ask(3, drives(true))), 11);
  controller_.release_e_stop();
  const json released = client_.ask(4, move_to(800, 5, 600));
  EXPECT_EQ(code(released), 17);
  EXPECT_EQ(released["state"]["e_stop"], false);
  EXPECT_EQ(released["state"]["drives"], false);
  EXPECT_EQ(released["state"]["alarms"],
            json::array({json{{"code", 11}, {"text", "emergency stop"}}}));
  EXPECT_EQ(code(client_.ask(5, drives(true))), 17);
  EXPECT_EQ(code(client_.ask(6, reset)), 0);
  EXPECT_EQ(code(client_.ask(7, move_to(800, 5, 600))), 11);
  EXPECT_EQ(code(client_.ask(8, drives(true))), 0);
  EXPECT_EQ(code(client_.ask(9, move_to(800, 5, 600))), 0);
  stream_until_still(client_);
  EXPECT_EQ(code(client_.ask(10, {{"cmd", "SET_DRIVES"}, {"drives", 1}})), 1);
  EXPECT_EQ(client_.ask(11, drives(false))["state"]["drives"], false);
}

TEST_F(Wire, FitsTheLongestAnswerIntoADatagram) {
  client_.open(18446744073709551600u);
  const std::string text(1000, '\x01');
  for (int i = 0; i < 9; ++i)
    controller_.fail_motion(text);
  const json request = {
      {"cmd", std::string(600, '"')}, {"c4g", 1}, {"session", 18446744073709551600u}, {"seq", 2}};
  client_.send(request);
  const json answer = client_.receive("ack");
  ASSERT_FALSE(answer.is_null());
  EXPECT_EQ(code(answer), 6);
  EXPECT_LE(answer.dump().size() + std::string(18, '0').size(), 1400u) << "with a seq of 19 digits";
}

TEST_F(Wire, KeepsItsParameters) {
  client_.open();
  const json frame = {1, 2, 3, 4, 5, 6};
  EXPECT_EQ(
      code(client_.ask(2, {{"cmd", "SET_PARAMETER"}, {"name", "user_frame"}, {"value", frame}})),
      0);
  EXPECT_EQ(client_.ask(3, {{"cmd", "GET_PARAMETER"}, {"name", "user_frame"}})["value"], frame);
  client_.ask(4, {{"cmd", "SET_LINSPEED"}, {"linear_speed", 125}});
  EXPECT_NEAR(
      client_.ask(5, {{"cmd", "GET_PARAMETER"}, {"name", "linear_speed"}})["value"].get<double>(),
      125, 1e-9);
}

TEST_F(Wire, SurvivesRubbish) {
  client_.open();
  for (const std::string& rubbish :
       {std::string(), std::string("{"), std::string("[1,2]"), std::string("{\"seq\":{}}"),
        std::string(1401, ' '), std::string("\xff\xfe"),
        std::string("{\"seq\":2,\"session\":100,\"c4g\":1,\"cmd\":7}"),
        std::string("{\"seq\":-2,\"session\":\"a\",\"c4g\":1,\"cmd\":\"STOP\"}"),
        std::string("{\"seq\":2,\"session\":100,\"c4g\":1,\"cmd\":\"\\ud800\"}")}) {
    client_.send(rubbish);
    const json packet = json::parse(rubbish, nullptr, false);
    if (packet.is_object()) client_.send(packet);
  }
  json ack = client_.ask(3, {{"cmd", "GET_STATIC_POSE"}});
  while (!ack.is_null() && ack["seq"] != 3)  // some rubbish was answered, with an error
    ack = client_.receive("ack");
  ASSERT_FALSE(ack.is_null());
  EXPECT_EQ(code(ack), 0);
}

TEST_F(Wire, DoesNothingThatWasSpoiltOnTheWay) {
  client_.open();
  json move = move_to(800, 100, 600);
  move.update({{"c4g", 1}, {"session", 100}, {"seq", 2}});
  std::string datagram = scan_cell_sim::sealed(move);
  datagram[datagram.find("800")] = '9';
  client_.send(datagram);
  client_.send(move.dump());  // not sealed
  EXPECT_TRUE(client_.receive(200).is_null());
  EXPECT_EQ(controller_.motions_begun(), 0u);
  const std::string sealed = scan_cell_sim::sealed({{"a", 1}});
  EXPECT_EQ(sealed, R"({"a":1,"crc":2801990766})");
}

TEST_F(Wire, LosesRepeatsAndReordersOnRequest) {
  client_.open();
  ControllerFaults faults;
  faults.to_client.lost = 0.1;
  faults.to_client.repeated = 0.1;
  faults.to_client.delayed = 0.1;
  faults.to_client.delay = 0.02;
  controller_.set_faults(faults);
  client_.send(json{{"c4g", 1},
                    {"session", 100},
                    {"seq", 2},
                    {"cmd", "MOVE_CARTESIAN"},
                    {"pose", {800, 200, 600, 0, 180, 180}},
                    {"camera_fps", 0}});
  std::set<std::uint64_t> numbers;
  std::uint64_t newest = 0;
  int repeated = 0;
  int late = 0;
  for (json state = client_.receive("state"); !state.is_null();
       state = client_.receive("state", 500)) {
    const auto number = state["n"].get<std::uint64_t>();
    if (!numbers.insert(number).second) {
      ++repeated;
    } else if (number < newest) {
      ++late;
    }
    newest = std::max(newest, number);
  }
  EXPECT_GT(repeated, 0);
  EXPECT_GT(late, 0);
  EXPECT_LT(numbers.size(), newest);
}

TEST_F(Wire, IsSilentWhileTheLinkIsDown) {
  client_.open();
  ControllerFaults faults;
  faults.to_client.link_down = true;
  faults.from_client.link_down = true;
  controller_.set_faults(faults);
  client_.send(json{{"c4g", 1}, {"session", 100}, {"seq", 2}, {"cmd", "STOP"}});
  EXPECT_TRUE(client_.receive(300).is_null());
  controller_.set_faults({});
  EXPECT_EQ(code(client_.ask(2, {{"cmd", "STOP"}})), 0);
}

TEST_F(Wire, LetsItsClockDrift) {
  ControllerFaults faults;
  faults.clock_drift = 0.5;
  controller_.set_faults(faults);
  client_.open();
  const Nanoseconds host = host_now();
  const auto t = client_.ask(2, {{"cmd", "GET_STATIC_POSE"}})["state"]["t"].get<std::int64_t>();
  usleep(200000);
  const auto u = client_.ask(3, {{"cmd", "GET_STATIC_POSE"}})["state"]["t"].get<std::int64_t>();
  const double passed = static_cast<double>(host_now() - host) / 1000;
  EXPECT_GT(static_cast<double>(u - t), 1.5 * 200000 * 0.999);
  EXPECT_LT(static_cast<double>(u - t), 1.5 * passed * 1.001);
}

TEST(ControllerStart, SaysWhichPortIsTaken) {
  const Controller first(any_port());
  ControllerOptions same;
  same.port = first.port();
  try {
    const Controller second(same);
    FAIL() << "took a taken port";
  } catch (const scan_cell_common::ConnectionError& error) {
    EXPECT_NE(std::string(error.what()).find(std::to_string(first.port())), std::string::npos);
  }
  ControllerOptions bad;
  bad.address = "robot";
  EXPECT_THROW(Controller{bad}, scan_cell_common::InvalidParameter);
}
