// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// What happens with a controller that violates c4g_protocol.md.
#include <gtest/gtest.h>

#include <algorithm>

#include "link/client_test.h"
#include "scan_cell_common/errors/errors.h"

using namespace c4g_driver;  // NOLINT
using nlohmann::json;
using scan_cell_common::Error;

namespace {

const char* const kHostile =
    "first\nsecond\r\x1b[2J\x1b]0;title\x07\x7f\xc2\x9b"
    "31m caf\xc3\xa9";
const char* const kCleaned = "first?second??[2J?]0;title???31m caf?";

bool is_printable(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

class LawlessController : public ClientTest {
 protected:
  /// Answers GET_PARAMETER `name` with this, JSON or nothing.
  void answer_parameter(const std::string& name, const std::optional<json>& value) {
    controller_->play([this, name, value](const json& request) -> std::optional<std::vector<json>> {
      if (request.value("name", "") != name) return std::nullopt;
      json answer = controller_->acknowledge(request);
      answer.erase("value");
      if (value) answer["value"] = *value;
      return std::vector<json>{answer};
    });
  }

  /// The refusal of a motion that must not be sent.
  std::string refusal_of_a_line() {
    try {
      client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 0);
      ADD_FAILURE() << "not refused";
    } catch (const Error& error) {
      EXPECT_TRUE(controller_->requests("MOVE_CARTESIAN").empty());
      return error.what();
    }
    return "";
  }
};

}  // namespace

TEST_F(LawlessController, MovesNothingUnderASettingThatTheProtocolDoesNotKnow) {
  connect();
  const std::vector<std::optional<json>> unknown = {
      "circular", "Linear", "linear ", "", 7, nullptr, json::array({"linear"}), std::nullopt};
  for (const std::string name : {"motion_type", "interpolation"}) {
    for (const auto& value : unknown) {
      answer_parameter(name, value);
      const std::string said = refusal_of_a_line();
      EXPECT_NE(said.find(name), std::string::npos) << said;
      EXPECT_NE(said.find(value ? value->dump() : "no value"), std::string::npos) << said;
    }
  }
  answer_parameter("interpolation", "joint");  // a word of the other parameter
  EXPECT_NE(refusal_of_a_line().find("interpolation"), std::string::npos);
  answer_parameter("motion_type", "euler");
  EXPECT_NE(refusal_of_a_line().find("motion_type"), std::string::npos);
}

TEST_F(LawlessController, MovesNothingWithoutAnOverrideOrASpeed) {
  link_timeout_ = 0.2;
  const std::vector<std::pair<std::string, double>> bad = {{"override", 0},
                                                           {"override", -50},
                                                           {"override", 101},
                                                           {"linear_speed", 0},
                                                           {"linear_speed", -250}};
  for (const auto& [key, value] : bad) {
    controller_ = std::make_unique<FakeController>();
    connect();
    controller_->set_state({{key, value}});
    ASSERT_TRUE(eventually([this] { return !client_->link().up; })) << key << " " << value;
    const std::string said = refusal_of_a_line();
    EXPECT_NE(said.find(key), std::string::npos) << said;
    EXPECT_THROW(client_->move_to_joints({0, 0.1, -2.1, 0, 0.8, 0}, 0), Error);
    EXPECT_TRUE(controller_->requests("MOVE_JOINT").empty());
    controller_->set_state({{"override", 0.01}, {"linear_speed", 0.01}});
    EXPECT_TRUE(eventually([this] { return client_->link().up; })) << "the least that is allowed";
  }
}

TEST_F(LawlessController, EndsTheMotionWhereItsOverrideFallsToNothing) {
  connect();
  client_->move_to_pose(looking_down(0.8, 0.2, 0.6), 0);
  controller_->set_state({{"override", 0}});
  EXPECT_EQ(client_->wait_for_goal(10).outcome(), Goal::Outcome::kLinkLost);
  EXPECT_NE(client_->goal().message().find("override"), std::string::npos)
      << client_->goal().message();
}

TEST_F(LawlessController, CannotCommandATerminalByItsAlarmsAndErrors) {
  connect();
  controller_->set_state({{"alarms", {{{"code", 15}, {"text", kHostile}}}},
                          {"error", {{"code", 15}, {"text", kHostile}}}});
  ASSERT_TRUE(eventually([this] { return !client_->latest()->robot.alarms.empty(); }));
  const RobotState robot = client_->latest()->robot;
  EXPECT_STREQ(robot.alarms.front().text.c_str(), kCleaned);
  EXPECT_STREQ(robot.error->text.c_str(), kCleaned);
}

TEST_F(LawlessController, CannotCommandATerminalByWhatItRefuses) {
  connect();
  controller_->play([this](const json& request) -> std::optional<std::vector<json>> {
    if (request["cmd"] != "SET_DRIVES") return std::nullopt;
    json answer = controller_->acknowledge(request);
    answer["error"] = {{"code", 16}, {"text", kHostile}};
    return std::vector<json>{answer};
  });
  try {
    client_->set_drives(true);
    FAIL() << "was not refused";
  } catch (const Error& error) {
    EXPECT_TRUE(is_printable(error.what())) << error.what();
    EXPECT_NE(std::string(error.what()).find(kCleaned), std::string::npos) << error.what();
  }
}

TEST_F(LawlessController, CannotCommandATerminalByTheReasonItClosesASession) {
  connect();
  controller_->play([](const json& request) -> std::optional<std::vector<json>> {
    return std::vector<json>{{{"c4g", 1},
                              {"session", request["session"]},
                              {"type", "ack"},
                              {"seq", request["seq"]},
                              {"error", {{"code", 4}, {"text", kHostile}}}}};
  });
  ASSERT_TRUE(eventually([this] { return !client_->link().up; }));
  EXPECT_NE(client_->link().message.find(kCleaned), std::string::npos) << client_->link().message;
}

TEST_F(LawlessController, CannotCommandATerminalByItsParameters) {
  connect();
  const json model = {kHostile, "\x7f", "NJ-4 \"arm\" \\"};
  answer_parameter("model", model);
  const std::string value = client_->get_parameter("model");
  EXPECT_TRUE(is_printable(value)) << value;
  EXPECT_EQ(json::parse(value), model) << "nothing of it is lost";
  answer_parameter("motion_type", kHostile);
  EXPECT_TRUE(is_printable(refusal_of_a_line()));
}

TEST_F(LawlessController, ShowsTextsUpToEightyCharacters) {
  connect();
  const std::string most(80, 'x');
  controller_->set_state({{"alarms", {{{"code", 15}, {"text", "\xc3\xa9" + most}}}}});
  ASSERT_TRUE(eventually([this] { return !client_->latest()->robot.alarms.empty(); }));
  EXPECT_EQ(client_->latest()->robot.alarms.front().text.c_str(), "?" + most.substr(1));
}
