// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The client against a scripted controller on real sockets.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "c4g_driver/client.h"
#include "fake_controller.h"
#include "scan_cell_common/errors.h"

using c4g_driver::Client;
using c4g_driver::ClientOptions;
using c4g_driver::Goal;
using c4g_driver::MeasuredState;
using nlohmann::json;
using scan_cell_common::ConnectionError;
using scan_cell_common::Nanoseconds;
using scan_cell_common::Refused;
using std::chrono::steady_clock;

namespace {

bool eventually(const std::function<bool()>& condition, double seconds = 10) {
  const auto deadline = steady_clock::now() + std::chrono::duration<double>(seconds);
  while (steady_clock::now() < deadline) {
    if (condition()) return true;
    usleep(2000);
  }
  return condition();
}

Nanoseconds host_now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

Eigen::Isometry3d looking_down(double x, double y, double z) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << x, y, z;
  pose.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  return pose;
}

/// All poses the client handed on.
class Heard {
 public:
  void operator()(const MeasuredState& state) {
    const std::lock_guard<std::mutex> lock(mutex_);
    states_.push_back(state);
  }
  std::vector<MeasuredState> states() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return states_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<MeasuredState> states_;
};

class ClientTest : public testing::Test {
 protected:
  ClientOptions options(std::uint16_t port) const {
    ClientOptions result;
    result.port = port;
    result.reconnect_period = 0.05;
    result.link_timeout = link_timeout_;
    return result;
  }

  void connect() {
    client_ = std::make_unique<Client>(options(controller_->port()),
                                       [this](const MeasuredState& state) { heard_(state); });
    ASSERT_TRUE(eventually([this] { return client_->link().up; }));
  }

  bool poses_heard_at(const std::vector<std::int64_t>& microseconds) {
    std::vector<std::int64_t> times;
    for (const MeasuredState& state : heard_.states()) {
      if (state.robot.controller_time >= 1'000'000'000'000)  // polls are in the first seconds
        times.push_back(state.robot.controller_time / 1000);
    }
    return times == microseconds;
  }

  /// A stream that test writes by hand is ahead of the polls' time, so these are dropped.
  static constexpr double kPatient = 20;

  void TearDown() override { hold_ = false; }

  std::atomic<bool> hold_{false};  // a listener that takes its time
  std::atomic<bool> held_{false};
  Heard heard_;
  double link_timeout_ = 0.5;
  std::unique_ptr<FakeController> controller_ = std::make_unique<FakeController>();
  std::unique_ptr<Client> client_;
};

}  // namespace

TEST_F(ClientTest, HandsOnEveryPoseOnceInTheOrderOfTime) {
  link_timeout_ = kPatient;
  connect();
  controller_->stream(1, 1'000'000'000);
  controller_->stream(2, 1'000'004'000);
  controller_->stream(2, 1'000'004'000);
  controller_->stream(5, 1'000'016'000);
  controller_->stream(4, 1'000'012'000);
  controller_->stream(6, 1'000'020'000);
  EXPECT_TRUE(eventually([this] {
    return poses_heard_at({1'000'000'000, 1'000'004'000, 1'000'016'000, 1'000'020'000});
  }));
  EXPECT_EQ(client_->link().stream.repeated, 1u);
  EXPECT_EQ(client_->link().stream.reordered, 1u);
  EXPECT_EQ(client_->link().stream.lost, 1u);
  EXPECT_TRUE(eventually([this] { return client_->link().dropped.overtaken > 0; })) << "the polls";
}

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
  EXPECT_EQ(goal.outcome(), Goal::Outcome::LinkLost);
  EXPECT_NE(goal.message().find("sends no fresh poses"), std::string::npos) << goal.message();
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

TEST_F(ClientTest, StampsPosesWithTheInstantOfTheirMeasurement) {
  link_timeout_ = kPatient;
  connect();
  // a datagram that took 50 ms: its stamp must not be its arrival
  const Nanoseconds sent = host_now();
  controller_->stream(1, 1'000'000'000);
  ASSERT_TRUE(eventually([this] { return poses_heard_at({1'000'000'000}); }));
  const Nanoseconds heard = host_now();
  usleep(150'000);
  controller_->stream(2, 1'000'100'000);
  ASSERT_TRUE(eventually([this] { return poses_heard_at({1'000'000'000, 1'000'100'000}); }));
  const Nanoseconds stamp = heard_.states().back().time;
  EXPECT_GE(stamp, sent + 100'000'000);
  EXPECT_LE(stamp, heard + 100'000'000);
}

TEST_F(ClientTest, StopsIfTheControllerDiesInAMotion) {
  connect();
  client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100);
  const auto start = steady_clock::now();
  controller_.reset();
  const Goal goal = client_->wait_for_goal(10);
  EXPECT_EQ(goal.outcome(), Goal::Outcome::LinkLost);
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
  ASSERT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::LinkLost);
  controller_ = std::make_unique<FakeController>(port);
  ASSERT_TRUE(eventually([this] { return client_->link().up; }));
  ASSERT_TRUE(eventually([this] { return controller_->requests("GET_STATIC_POSE").size() > 3; }));
  EXPECT_TRUE(controller_->requests("MOVE_CARTESIAN").empty());
  EXPECT_GT(controller_->requests().back()["session"].get<std::uint64_t>(), session);
  EXPECT_EQ(client_->goal().outcome(), Goal::Outcome::LinkLost);
  controller_->set_state({{"status", "arrived"}, {"motion", 2}});  // even if it claims so
  ASSERT_TRUE(eventually(
      [this] { return client_->latest()->robot.status == c4g_driver::MotionStatus::Arrived; }));
  EXPECT_EQ(client_->goal().outcome(), Goal::Outcome::LinkLost);
}

TEST_F(ClientTest, RepeatsAMoveUnderItsNumberUntilItIsAcknowledged) {
  connect();
  int asked = 0;
  controller_->play([&asked](const json& request) -> std::optional<std::vector<json>> {
    if (request["cmd"] != "MOVE_CARTESIAN" || ++asked > 3) return std::nullopt;
    return std::vector<json>{};  // the acknowledgement is lost
  });
  client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100);
  std::set<std::uint64_t> numbers;
  const auto moves = controller_->requests("MOVE_CARTESIAN");
  for (const json& move : moves)
    numbers.insert(move["seq"].get<std::uint64_t>());
  EXPECT_GE(moves.size(), 4u);
  EXPECT_EQ(numbers.size(), 1u);
  EXPECT_TRUE(client_->goal().underway());
}

TEST_F(ClientTest, TakesAMoveThatIsNeverAcknowledgedForALostLink) {
  connect();
  controller_->play([](const json& request) -> std::optional<std::vector<json>> {
    if (request["cmd"] != "MOVE_JOINT") return std::nullopt;
    return std::vector<json>{};
  });
  const std::uint64_t session = controller_->requests().back()["session"].get<std::uint64_t>();
  EXPECT_THROW(client_->move_to_joints({0, 0, -1.5, 0, 1.5, 0}, 0), ConnectionError);
  EXPECT_EQ(client_->goal().outcome(), Goal::Outcome::LinkLost);
  // the new session makes the controller forget the motion, should it have begun
  ASSERT_TRUE(eventually(
      [&] { return controller_->requests().back()["session"].get<std::uint64_t>() > session; }));
}

TEST_F(ClientTest, TellsWhyTheControllerRefused) {
  connect();
  controller_->play([this](const json& request) -> std::optional<std::vector<json>> {
    if (request["cmd"] != "MOVE_CARTESIAN") return std::nullopt;
    json answer = controller_->acknowledge(request);
    answer["error"] = {{"code", 13}, {"text", "no posture reaches the pose"}};
    return std::vector<json>{answer};
  });
  try {
    client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100);
    FAIL() << "was not refused";
  } catch (const Refused& refused) {
    EXPECT_NE(refused.value().find("no posture reaches the pose"), std::string::npos);
  }
  EXPECT_EQ(client_->goal().outcome(), Goal::Outcome::None);
}

TEST_F(ClientTest, SendsNothingOfATargetOutsideTheLimits) {
  connect();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(client_->move_to_pose(looking_down(nan, 0, 0.6), 0), Refused);
  EXPECT_THROW(client_->move_to_pose(looking_down(5, 0, 0.6), 0), Refused);
  EXPECT_THROW(client_->move_to_pose(looking_down(0.8, 0, 0.6), -1), Refused);
  EXPECT_THROW(client_->move_to_joints({0, 0, 0.1, 0, 0, 0}, 0), Refused);
  EXPECT_THROW(client_->move_to_joints({0, 0}, 0), Refused);
  EXPECT_THROW(client_->move_to_joints({0, 1.3, -M_PI / 2, 0, 0, 0}, 0),
               Refused);  // into the floor
  EXPECT_THROW(client_->set_linear_speed(2), Refused);
  EXPECT_THROW(client_->set_override(0), Refused);
  EXPECT_THROW(client_->set_parameter("motion_type", "joint"), Refused);
  EXPECT_THROW(client_->set_parameter("linear_speed", "1501"), Refused);
  EXPECT_THROW(client_->set_parameter("linear_speed", "\"fast\""), Refused);
  EXPECT_THROW(client_->set_parameter("override", "101"), Refused);
  for (const json& request : controller_->requests())
    EXPECT_TRUE(request["cmd"] == "OPEN" || request["cmd"] == "GET_STATIC_POSE") << request;
}

TEST_F(ClientTest, SendsNoLineWhileTheControllersOwnSpeedIsAboveTheLimit) {
  ClientOptions slow = options(controller_->port());
  slow.limits.most_linear_speed = 0.2;  // the controller starts with 250 mm/s
  client_ = std::make_unique<Client>(slow, nullptr);
  ASSERT_TRUE(eventually([this] { return client_->link().up; }));
  EXPECT_THROW(client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100), Refused);
  EXPECT_THROW(client_->set_parameter("linear_speed", "201"), Refused);
  EXPECT_TRUE(controller_->requests("MOVE_CARTESIAN").empty());
  EXPECT_NO_THROW(client_->set_parameter("linear_speed", "200"));
  controller_->set_state({{"linear_speed", 200}});
  ASSERT_TRUE(eventually([this] { return client_->latest()->robot.linear_speed < 0.21; }));
  EXPECT_NO_THROW(client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100));
}

TEST_F(ClientTest, RefusesASecondMotionBeforeTheFirstEnded) {
  connect();
  client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100);
  EXPECT_THROW(client_->move_to_pose(looking_down(0.8, 0.1, 0.6), 100), Refused);
  EXPECT_EQ(controller_->requests("MOVE_CARTESIAN").size(), 1u);
  EXPECT_THROW(client_->static_pose(), Refused);
}

TEST_F(ClientTest, EndsTheGoalAsTheControllerSays) {
  connect();
  const auto move = [this] { client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 100); };
  move();
  controller_->set_state({{"status", "arrived"}, {"pose", {800, 200, 600, 0, 180, 180}}});
  EXPECT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::Reached);
  move();
  controller_->set_state({{"status", "arrived"}, {"pose", {800, 150, 600, 0, 180, 180}}});
  EXPECT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::Failed);
  move();
  controller_->set_state({{"status", "stopped"}});
  EXPECT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::Stopped);
  move();
  controller_->set_state(
      {{"status", "error"}, {"error", {{"code", 15}, {"text", "following error of J2"}}}});
  EXPECT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::Failed);
  EXPECT_EQ(client_->goal().message(), "following error of J2");
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
  EXPECT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::LinkLost);
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
  EXPECT_EQ(goal.outcome(), Goal::Outcome::LinkLost);
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
  hold_ = true;  // an answer stays half handled, while its session is given up
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
  EXPECT_EQ(after.malformed, before.malformed + 2);
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

TEST_F(ClientTest, CarriesSettingsAndParametersInWireUnits) {
  connect();
  controller_->play([this](const json& request) -> std::optional<std::vector<json>> {
    json answer = controller_->acknowledge(request);
    if (request["cmd"] == "GET_PARAMETER") answer["value"] = "linear";
    return std::vector<json>{answer};
  });
  client_->set_linear_speed(0.125);
  client_->set_override(30);
  client_->set_parameter("interpolation", "\"euler\"");
  EXPECT_EQ(client_->get_parameter("motion_type"), "\"linear\"");
  EXPECT_EQ(controller_->requests("SET_LINSPEED").back()["linear_speed"], 125);
  EXPECT_EQ(controller_->requests("SET_OVERRIDE").back()["override"], 30);
  EXPECT_EQ(controller_->requests("SET_PARAMETER").back()["value"], "euler");
}

TEST(ClientOptions, AreChecked) {
  ClientOptions options;
  options.address = "the robot";
  EXPECT_THROW(Client(options, nullptr), scan_cell_common::InvalidParameter);
  options = ClientOptions();
  options.link_timeout = 0;
  EXPECT_THROW(Client(options, nullptr), scan_cell_common::InvalidParameter);
}

TEST(UdpSocket, TakesNothingFromAnybodyButItsPeer) {
  FakeController peer;
  FakeController stranger;
  c4g_driver::UdpSocket udp("127.0.0.1", peer.port(), 100);
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
