// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "link/client_test.h"
#include "robot/inverse_kinematics.h"
#include "scan_cell_common/errors/errors.h"
#include "wire/wire_units.h"

using namespace c4g_driver;  // NOLINT
using nlohmann::json;
using scan_cell_common::Refused;

namespace {

/// What the controller reports when the flange is there, looking down.
json standing_at(double x, double y, double z) {
  const auto flange = looking_down(x, y, z);
  const auto joints = step_to(smart5_six(), flange, degrees(0, 8, -124, 0, 48, 0));
  return {{"pose", to_wire(flange)}, {"joints", to_wire(joints.value())}};
}

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

TEST_F(ClientTest, RepeatsAMoveUnderItsNumberUntilItIsAcknowledged) {
  const std::vector<std::pair<std::string, std::function<void(Client&)>>> kinds = {
      {"MOVE_CARTESIAN",
       [](Client& client) { client.move_to_pose(looking_down(0.8, 0.2, 0.6), 100); }},
      {"MOVE_CIRCULAR",
       [](Client& client) {
         client.move_along_arc(looking_down(0.9, 0.1, 0.6), looking_down(0.8, 0.2, 0.6), 100);
       }},
      {"MOVE_JOINT", [](Client& client) {
         client.move_to_joints({0, 0.1, -2, 0, 0.8, 0}, 0);
       }}};
  for (const auto& [command, move] : kinds) {
    controller_ = std::make_unique<FakeController>();
    connect();
    int asked = 0;
    controller_->play(
        [&, wanted = command](const json& request) -> std::optional<std::vector<json>> {
          if (request["cmd"] != wanted || ++asked > 3) return std::nullopt;
          return std::vector<json>{};  // the acknowledgement is lost
        });
    move(*client_);
    std::set<std::uint64_t> numbers;
    const auto moves = controller_->requests(command);
    for (const json& sent : moves)
      numbers.insert(sent["seq"].get<std::uint64_t>());
    EXPECT_GE(moves.size(), 4u) << command;
    EXPECT_EQ(numbers.size(), 1u) << command;
    EXPECT_TRUE(client_->goal().underway()) << command;
    client_.reset();
  }
}

TEST_F(ClientTest, SendsNothingOfAnArcThatIsNoneAndNamesThePoint) {
  connect();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Isometry3d via = looking_down(0.9, 0.1, 0.6), end = looking_down(0.8, 0.2, 0.6);
  Eigen::Isometry3d skewed = via;
  skewed.linear()(0, 0) = 2;
  const std::vector<std::tuple<Eigen::Isometry3d, Eigen::Isometry3d, std::string>> bad = {
      {looking_down(nan, 0.1, 0.6), end, "via x: nan m"},
      {looking_down(0.9, 5, 0.6), end, "via y: 5 m"},
      {skewed, end, "via orientation: not a rotation"},
      {via, looking_down(0.8, 0.2, nan), "target z: nan m"},
      {via, via, "via: 0 m from the target"},
      {looking_down(0.8, 0, 0.6), end, "via: 0 m from where the robot stands"},
      {via, looking_down(0.8, 0, 0.6), "target: 0 m from where the robot stands"},
      {looking_down(0.8, 0.1, 0.6), end, "via: only "},
      {looking_down(1.3, 0.1, 1.5), end, "via: out of reach"}};
  for (const auto& [on_the_way, target, reason] : bad) {
    try {
      client_->move_along_arc(on_the_way, target, 0);
      ADD_FAILURE() << "was not refused: " << reason;
    } catch (const Refused& refused) {
      EXPECT_EQ(std::string(refused.what()).find(reason), 0u) << refused.what();
    }
  }
  EXPECT_THROW(client_->move_along_arc(via, end, -1), Refused);
  EXPECT_TRUE(controller_->requests("MOVE_CIRCULAR").empty());
  EXPECT_NO_THROW(client_->move_along_arc(via, end, 0));
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
  EXPECT_EQ(client_->goal().outcome(), Goal::Outcome::kNone);
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
  slow.limits.max_linear_speed = 0.2;  // the controller starts with 250 mm/s
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
  controller_->set_state(standing_at(0.8, 0.2, 0.6));
  controller_->set_state({{"status", "arrived"}});
  EXPECT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::kReached);
  move();
  controller_->set_state(standing_at(0.8, 0.15, 0.6));
  controller_->set_state({{"status", "arrived"}});
  EXPECT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::kFailed);
  move();
  controller_->set_state({{"status", "stopped"}});
  EXPECT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::kStopped);
  move();
  controller_->set_state(
      {{"status", "error"}, {"error", {{"code", 15}, {"text", "following error of J2"}}}});
  EXPECT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::kFailed);
  EXPECT_EQ(client_->goal().message(), "following error of J2");
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

TEST_F(ClientTest, RefusesAValueThatIsTooLongBeforeItReadsIt) {
  connect();
  const std::string deep = std::string(1'000'000, '[') + std::string(1'000'000, ']');
  EXPECT_THROW(client_->set_parameter("interpolation", deep), scan_cell_common::Refused);
  EXPECT_TRUE(controller_->requests("SET_PARAMETER").empty());
  client_->set_parameter("interpolation", "\"euler\"");
  EXPECT_TRUE(client_->link().up);
}

TEST_F(ClientTest, ChecksALineWithTheSettingsThatAreInForceWhoeverMadeThem) {
  connect();
  std::atomic<double> rotational_speed = 60;
  controller_->play([&](const json& request) -> std::optional<std::vector<json>> {
    json answer = controller_->acknowledge(request);
    if (request.value("name", "") == "rotational_speed") answer["value"] = rotational_speed.load();
    return std::vector<json>{answer};
  });
  Eigen::Isometry3d rolled = looking_down(0.8, 0, 0.6);
  rolled.rotate(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitZ()));
  rotational_speed = 1100;  // J6 does 550 degrees a second
  EXPECT_THROW(client_->move_to_pose(rolled, 0), Refused);
  controller_->set_state({{"override", 40}});
  ASSERT_TRUE(eventually([this] { return client_->latest()->robot.override == 40; }));
  EXPECT_TRUE(controller_->requests("MOVE_CARTESIAN").empty());
  EXPECT_NO_THROW(client_->move_to_pose(rolled, 0));
  EXPECT_THROW(client_->set_override(51), Refused) << "while it lasts";
  EXPECT_NO_THROW(client_->set_override(49));
  rotational_speed = 0;
  EXPECT_THROW(client_->move_to_pose(rolled, 0), scan_cell_common::Error);
}

TEST_F(ClientTest, KeepsTo250MillimetresASecondInManualOperation) {
  ClientOptions manual = options(controller_->port());
  manual.limits.operation = Operation::kManual;
  client_ = std::make_unique<Client>(manual, nullptr);
  ASSERT_TRUE(eventually([this] { return client_->link().up; }));
  EXPECT_THROW(client_->set_linear_speed(0.26), Refused);
  EXPECT_THROW(client_->set_parameter("linear_speed", "260"), Refused);
  EXPECT_NO_THROW(client_->set_linear_speed(0.25));
  EXPECT_THROW(client_->move_to_joints({1, 0.1424, -2.1661, 0, 0.8331, 0}, 0), Refused);
  EXPECT_TRUE(controller_->requests("MOVE_JOINT").empty());
  controller_->set_state({{"override", 10}});
  ASSERT_TRUE(eventually([this] { return client_->latest()->robot.override == 10; }));
  EXPECT_NO_THROW(client_->move_to_joints({1, 0.1424, -2.1661, 0, 0.8331, 0}, 0));
  EXPECT_THROW(client_->set_override(20), Refused) << "that would make it faster on its way";
}

TEST_F(ClientTest, SendsNoMotionToARobotItsModelDoesNotDescribe) {
  connect();
  controller_->set_state({{"pose", {800, 0, 850, 0, 180, 180}}});
  ASSERT_TRUE(
      eventually([this] { return client_->latest()->robot.flange.translation().z() > 0.84; }));
  EXPECT_THROW(client_->move_to_pose(looking_down(0.8, 0.1, 0.8), 0), Refused);
  EXPECT_THROW(client_->move_to_joints({0, 0.1, -2.1, 0, 0.8, 0}, 0), Refused);
  EXPECT_TRUE(controller_->requests("MOVE_CARTESIAN").empty());
  EXPECT_TRUE(controller_->requests("MOVE_JOINT").empty());
}

TEST(ClientOptions, AreChecked) {
  ClientOptions options;
  EXPECT_THROW(Client(options, nullptr), scan_cell_common::InvalidParameter) << "no robot";
  options.robot = std::make_shared<RobotModel>(smart5_six());
  options.address = "the robot";
  EXPECT_THROW(Client(options, nullptr), scan_cell_common::InvalidParameter);
  options.address = "127.0.0.1";
  options.link_timeout = 0;
  EXPECT_THROW(Client(options, nullptr), scan_cell_common::InvalidParameter);
}
