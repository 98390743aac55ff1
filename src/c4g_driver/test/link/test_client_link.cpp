// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "link/client_test.h"
#include "scan_cell_common/errors/errors.h"
#include "wire/peer_socket.h"

using namespace c4g_driver;  // NOLINT
using nlohmann::json;
using scan_cell_common::ConnectionError;

TEST_F(ClientTest, TakesAMotionWithoutAStreamForALostLink) {
  connect();
  client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100);
  const auto start = steady_clock::now();
  while (steady_clock::now() - start < std::chrono::seconds(1)) {
    ASSERT_TRUE(client_->goal().underway()) << client_->goal().message();
    usleep(20'000);
  }
  controller_->stop_streaming();  // it answers as before, with a new pose each time
  const Goal goal = client_->wait_for_goal(10);
  EXPECT_EQ(goal.outcome(), Goal::Outcome::kLinkLost);
  EXPECT_NE(goal.message().find("sends no fresh poses"), std::string::npos) << goal.message();
}

TEST_F(ClientTest, EndsTheSessionOfALostLinkAtOnceHoweverRarelyItTriesToConnect) {
  ClientOptions rarely = options(controller_->port());
  rarely.reconnect_period = 1;
  client_ = std::make_unique<Client>(rarely, [](const MeasuredState&) {});
  ASSERT_TRUE(eventually([this] { return client_->link().up; }));
  client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100);
  usleep(1'100'000);  // until another attempt may follow
  const json first = controller_->requests().back()["session"];
  controller_->stop_streaming();
  EXPECT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::kLinkLost);
  EXPECT_TRUE(
      eventually([&] { return controller_->requests("OPEN").back()["session"] != first; }, 0.5));
}

TEST_F(ClientTest, TakesAControllerThatRefusesToTellPosesForALostLink) {
  connect();
  controller_->play([this](const json& request) -> std::optional<std::vector<json>> {
    if (request["cmd"] == "OPEN") return std::nullopt;
    json answer = controller_->acknowledge(request);
    answer["error"] = {{"code", 6}, {"text", "unknown command"}};
    answer.erase("state");
    return std::vector<json>{answer};
  });
  EXPECT_TRUE(eventually([this] { return client_->link().losses > 0; }));
}

TEST_F(ClientTest, TakesAControllerWhoseClockStandsForALostLink) {
  connect();
  controller_->play([this](const json& request) -> std::optional<std::vector<json>> {
    json answer = controller_->acknowledge(request);
    answer["state"]["t"] = 1'000'000'000;
    return std::vector<json>{answer};
  });
  EXPECT_TRUE(eventually([this] { return client_->link().losses > 0; }));
}

TEST_F(ClientTest, StopsIfTheControllerDiesInAMotion) {
  connect();
  client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100);
  const auto start = steady_clock::now();
  controller_.reset();
  const Goal goal = client_->wait_for_goal(10);
  EXPECT_EQ(goal.outcome(), Goal::Outcome::kLinkLost);
  EXPECT_LT(steady_clock::now() - start, std::chrono::seconds(1));
  EXPECT_FALSE(client_->link().up);
  EXPECT_THROW(client_->stop(), ConnectionError);
}

TEST_F(ClientTest, NeverResumesAGoalWhenTheLinkIsBack) {
  connect();
  client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100);
  const std::uint16_t port = controller_->port();
  const std::uint64_t session = controller_->requests().back()["session"].get<std::uint64_t>();
  controller_.reset();
  ASSERT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::kLinkLost);
  controller_ = std::make_unique<FakeController>(port);
  ASSERT_TRUE(eventually([this] { return client_->link().up; }));
  ASSERT_TRUE(eventually([this] { return controller_->requests("GET_STATIC_POSE").size() > 3; }));
  EXPECT_TRUE(controller_->requests("MOVE_CARTESIAN").empty());
  EXPECT_GT(controller_->requests().back()["session"].get<std::uint64_t>(), session);
  EXPECT_EQ(client_->goal().outcome(), Goal::Outcome::kLinkLost);
  controller_->set_state({{"status", "arrived"}, {"motion", 2}});  // even if it claims arrival
  ASSERT_TRUE(eventually(
      [this] { return client_->latest()->robot.status == c4g_driver::MotionStatus::kArrived; }));
  EXPECT_EQ(client_->goal().outcome(), Goal::Outcome::kLinkLost);
}

TEST_F(ClientTest, TakesAMoveThatIsNeverAcknowledgedForALostLink) {
  connect();
  controller_->play([](const json& request) -> std::optional<std::vector<json>> {
    if (request["cmd"] != "MOVE_JOINT") return std::nullopt;
    return std::vector<json>{};
  });
  const std::uint64_t session = controller_->requests().back()["session"].get<std::uint64_t>();
  EXPECT_THROW(client_->move_to_joints({0, 0, -1.5, 0, 1.5, 0}, 0), ConnectionError);
  EXPECT_EQ(client_->goal().outcome(), Goal::Outcome::kLinkLost);
  // the new session makes the controller drop the motion, if it has begun
  ASSERT_TRUE(eventually(
      [&] { return controller_->requests().back()["session"].get<std::uint64_t>() > session; }));
}

TEST_F(ClientTest, DropsTheGoalWhenTheControllerForgotTheSession) {
  connect();
  client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100);
  const std::uint64_t session = controller_->requests().back()["session"].get<std::uint64_t>();
  controller_->play([this, session](const json& request) -> std::optional<std::vector<json>> {
    if (request["session"] != session) return std::nullopt;
    json answer = controller_->acknowledge(request);
    answer["error"] = {{"code", 3}, {"text", "this session is not open"}};
    answer.erase("state");
    return std::vector<json>{answer};
  });
  EXPECT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::kLinkLost);
  EXPECT_TRUE(eventually([this] { return client_->link().up; }));
}

TEST_F(ClientTest, DropsTheGoalWhenAnotherClientTookTheController) {
  connect();
  client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100);
  controller_->play([this](const json& request) -> std::optional<std::vector<json>> {
    json answer = controller_->acknowledge(request);
    answer["error"] = {{"code", 4}, {"text", "another client has the controller"}};
    answer.erase("state");
    return std::vector<json>{answer};
  });
  const Goal goal = client_->wait_for_goal(10);
  EXPECT_EQ(goal.outcome(), Goal::Outcome::kLinkLost);
  EXPECT_NE(goal.message().find("another client"), std::string::npos) << goal.message();
  EXPECT_FALSE(client_->link().up);
  EXPECT_THROW(client_->stop(), ConnectionError);
}

TEST_F(ClientTest, TakesNoLateAnswerOfAnOldSessionForThatOfANewOne) {
  client_ = std::make_unique<Client>(options(controller_->port()), [this](const MeasuredState&) {
    if (!hold_) return;
    held_ = true;
    while (hold_)
      usleep(1000);
  });
  ASSERT_TRUE(eventually([this] { return client_->link().up; }));
  const auto sessions = [this] {
    std::set<std::uint64_t> all;
    for (const json& open : controller_->requests("OPEN"))
      all.insert(open["session"].get<std::uint64_t>());
    return all.size();
  };
  ASSERT_EQ(sessions(), 1u);
  controller_->play([](const json& request) -> std::optional<std::vector<json>> {
    if (request["cmd"] != "OPEN") return std::nullopt;
    return std::vector<json>{};  // no new session is ever granted
  });
  hold_ = true;  // an answer stays half processed while its session is given up
  ASSERT_TRUE(eventually([&] { return held_ && sessions() == 2; }));
  hold_ = false;
  EXPECT_TRUE(eventually([&] { return sessions() >= 4; }));
  EXPECT_EQ(client_->link().losses, 1u);
  EXPECT_FALSE(client_->link().up);
}

TEST_F(ClientTest, IgnoresForeignSendersOldSessionsAndBadDatagrams) {
  link_timeout_ = kPatient;
  connect();
  const auto before = client_->link();
  FakeController stranger;
  controller_->stream(1, 1'000'000'000);
  controller_->stream(2, 1'001'000'000, {{"session", 1}});
  controller_->send(std::string(3000, ' '));
  controller_->send("{\"c4g\": 1, \"type\": \"state\"}");
  controller_->send("rubbish");
  stranger.send_to_client_of(*controller_, "boo");
  controller_->stream(2, 1'000'004'000);
  ASSERT_TRUE(eventually([this] { return poses_heard_at({1'000'000'000, 1'000'004'000}); }));
  const auto after = client_->link();
  EXPECT_EQ(after.foreign, before.foreign + 1);
  EXPECT_EQ(after.overlong, before.overlong + 1);
  EXPECT_EQ(after.malformed.count, before.malformed.count + 2);
  EXPECT_TRUE(after.up);
  EXPECT_EQ(after.stream.lost, 0u);
}

TEST_F(ClientTest, WaitsForAControllerThatIsNotThere) {
  const std::uint16_t port = controller_->port();
  controller_.reset();
  client_ = std::make_unique<Client>(options(port), nullptr);
  EXPECT_THROW(client_->set_override(50), ConnectionError);
  EXPECT_FALSE(client_->link().up);
  EXPECT_FALSE(client_->link().message.empty());
  EXPECT_FALSE(client_->latest());
  controller_ = std::make_unique<FakeController>(port);
  EXPECT_TRUE(eventually([this] { return client_->link().up; }));
  EXPECT_NO_THROW(client_->set_override(50));
}

TEST_F(ClientTest, SaysThatAnotherClientHasTheController) {
  controller_->play([this](const json& request) -> std::optional<std::vector<json>> {
    json answer = controller_->acknowledge(request);
    answer["error"] = {{"code", 4}, {"text", "another client has the controller"}};
    answer.erase("state");
    return std::vector<json>{answer};
  });
  client_ = std::make_unique<Client>(options(controller_->port()), nullptr);
  EXPECT_TRUE(eventually(
      [this] { return client_->link().message == "another client has the controller"; }));
  EXPECT_FALSE(client_->link().up);
}

TEST_F(ClientTest, StopsTheRobotAndClosesTheSessionAtItsEnd) {
  connect();
  client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100);
  client_.reset();
  EXPECT_EQ(controller_->requests("STOP").size(), 1u);
  EXPECT_EQ(controller_->requests().back()["cmd"], "CLOSE");
}

TEST(PeerSocket, TakesNothingFromAnybodyButItsPeer) {
  FakeController peer;
  FakeController stranger;
  c4g_driver::PeerSocket udp("0.0.0.0", "127.0.0.1", peer.port(), 100);
  const json hello = {{"cmd", "HELLO"}, {"seq", 1}, {"session", 1}};
  peer.play([&](const json&) -> std::optional<std::vector<json>> { return std::vector<json>{}; });
  ASSERT_TRUE(udp.send(hello.dump()));
  ASSERT_TRUE(eventually([&] { return !peer.requests().empty(); }));
  stranger.send_to_client_of(peer, "boo");
  EXPECT_FALSE(udp.receive(0.2));
  EXPECT_EQ(udp.foreign(), 1u);
  peer.send("hello");
  const auto received = udp.receive(2);
  ASSERT_TRUE(received);
  EXPECT_EQ(received->datagram, "hello");
  EXPECT_NEAR(static_cast<double>(host_now() - received->time), 0, 2e9);
}
