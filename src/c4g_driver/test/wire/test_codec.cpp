// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "scan_cell_common/errors/errors.h"
#include "wire/codec.h"
#include "wire/seal.h"

using c4g_driver::Acknowledgement;
using c4g_driver::StreamedState;
using nlohmann::json;
using scan_cell_common::ProtocolError;
using scan_cell_common::Refused;

namespace {

// as in c4g_protocol.md
const char* const kState = R"({"c4g": 1, "session": 1790000000000000, "type": "state", "n": 1204,
  "t": 48123456, "pose": [798.301, 42, 875.5, 0, 180, 180],
  "joints": [-3.0117, -0.6729, -108.0738, 0, 72.5991, -3.0117],
  "status": "moving", "motion": 13, "progress": 0.42, "waypoint": 7, "outputs": 5,
  "camera_fps": 100, "e_stop": false,
  "drives": true, "mode": "remote", "override": 100, "linear_speed": 100, "error": null,
  "alarms": []})";

json ack() {
  json state = json::parse(kState);
  return {{"c4g", 1},         {"session", 1790000000000000},
          {"type", "ack"},    {"seq", 17},
          {"error", nullptr}, {"state", state}};
}

json built(const c4g_driver::Request& request) {
  const std::string datagram = c4g_driver::build(request, 1790000000000000, 17);
  EXPECT_NO_THROW(c4g_driver::check_seal(datagram));
  json packet = json::parse(datagram);
  packet.erase("crc");
  return packet;
}

c4g_driver::Reply parsed(const json& packet) {
  return c4g_driver::parse(c4g_driver::seal(packet.dump()));
}

std::string complaint(const std::string& packet) {
  try {
    c4g_driver::parse(c4g_driver::seal(packet));
  } catch (const ProtocolError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(Build, WritesAMoveInJointsAsTheProtocolSays) {
  c4g_driver::Joints joints;
  joints << 0, 0, -M_PI / 2, 0, M_PI / 2, 0;
  EXPECT_EQ(built(c4g_driver::MoveJoint{joints, 0}), json::parse(R"({"c4g": 1,
    "session": 1790000000000000, "seq": 17, "cmd": "MOVE_JOINT",
    "joints": [0.0, 0.0, -90.0, 0.0, 90.0, 0.0], "camera_fps": 0.0})"));
}

TEST(Build, WritesAMoveAlongAnArcAsTheProtocolSays) {
  Eigen::Isometry3d via = Eigen::Isometry3d::Identity();
  via.translation() << 0.9, 0, 0.6;
  Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();
  flange.translation() << 0.8, -0.1, 0.65;
  json packet = built(c4g_driver::MoveCircular{via, flange, 50});
  EXPECT_EQ(packet["cmd"], "MOVE_CIRCULAR");
  EXPECT_EQ(packet["camera_fps"], 50);
  const std::vector<double> expected_via = {900, 0, 600, 0, 0, 0};
  const std::vector<double> expected_pose = {800, -100, 650, 0, 0, 0};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(packet["via"].at(i).get<double>(), expected_via[i], 1e-12);
    EXPECT_NEAR(packet["pose"].at(i).get<double>(), expected_pose[i], 1e-12);
  }
  EXPECT_EQ(packet["via"].size() + packet["pose"].size(), 12u);
  EXPECT_EQ(packet.size(), 7u);
}

TEST(Build, PutsTheCamerasRateIntoTheMove) {
  Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();
  flange.translation() << 0.8, 0.1, 0.6;
  const json packet = built(c4g_driver::MoveCartesian{flange, 100});
  EXPECT_EQ(packet["cmd"], "MOVE_CARTESIAN");
  EXPECT_EQ(packet["camera_fps"], 100);
  EXPECT_NEAR(packet["pose"][1].get<double>(), 100, 1e-12);
}

TEST(Build, WritesEveryOtherRequest) {
  EXPECT_EQ(built(c4g_driver::Open{})["cmd"], "OPEN");
  EXPECT_EQ(built(c4g_driver::Close{})["cmd"], "CLOSE");
  EXPECT_EQ(built(c4g_driver::Stop{})["cmd"], "STOP");
  EXPECT_EQ(built(c4g_driver::GetStaticPose{})["cmd"], "GET_STATIC_POSE");
  EXPECT_EQ(built(c4g_driver::SetOverride{42})["override"], 42);
  EXPECT_EQ(built(c4g_driver::SetLinearSpeed{0.125})["linear_speed"], 125);
  EXPECT_EQ(built(c4g_driver::GetParameter{"motion_type"})["name"], "motion_type");
  const json set = built(c4g_driver::SetParameter{"motion_type", "\"joint\""});
  EXPECT_EQ(set["cmd"], "SET_PARAMETER");
  EXPECT_EQ(set["value"], "joint");
  EXPECT_EQ(built(c4g_driver::SetDrives{true}), json::parse(R"({"c4g": 1,
    "session": 1790000000000000, "seq": 17, "cmd": "SET_DRIVES", "drives": true})"));
  EXPECT_EQ(built(c4g_driver::ResetAlarms{})["cmd"], "RESET_ALARMS");
}

TEST(Build, RefusesAParameterThatIsNotJsonOrTooLong) {
  EXPECT_THROW(built(c4g_driver::SetParameter{"motion_type", "joint"}), Refused);
  EXPECT_THROW(built(c4g_driver::SetParameter{"x", "\"" + std::string(1400, 'a') + "\""}), Refused);
  EXPECT_NO_THROW(built(c4g_driver::GetParameter{"\xff\xfe"}));
}

TEST(Seal, IsTheCrc32OfAllBytesBeforeIt) {
  // the check value of CRC-32/ISO-HDLC in the catalogue of parametrised CRC algorithms
  EXPECT_EQ(c4g_driver::seal("123456789}"), "123456789,\"crc\":3421780262}");
}

TEST(Seal, FindsEveryBitThatFlippedAndEveryCut) {
  const std::string sealed = c4g_driver::seal(kState);
  EXPECT_NO_THROW(c4g_driver::parse(sealed));
  for (std::size_t at = 0; at < sealed.size(); ++at) {
    EXPECT_THROW(c4g_driver::parse(sealed.substr(0, at)), ProtocolError) << at;
    for (int bit = 0; bit < 8; ++bit) {
      std::string spoilt = sealed;
      spoilt[at] = static_cast<char>(spoilt[at] ^ (1 << bit));
      EXPECT_THROW(c4g_driver::parse(spoilt), ProtocolError) << at << ", " << bit;
    }
  }
  EXPECT_THROW(c4g_driver::parse(kState), ProtocolError) << "not sealed at all";
  EXPECT_THROW(c4g_driver::parse(sealed + " "), ProtocolError);
}

TEST(Parse, ReadsAStateIntoSiUnits) {
  const auto state = std::get<StreamedState>(c4g_driver::parse(c4g_driver::seal(kState)));
  EXPECT_EQ(state.session, 1790000000000000u);
  EXPECT_EQ(state.number, 1204u);
  EXPECT_EQ(state.robot.controller_time, 48123456000);
  EXPECT_TRUE(state.robot.flange.translation().isApprox(Eigen::Vector3d(0.798301, 0.042, 0.8755)));
  EXPECT_TRUE(state.robot.flange.linear().isApprox(
      Eigen::Matrix3d(Eigen::Vector3d(1, -1, -1).asDiagonal())));
  EXPECT_NEAR(state.robot.joints[2], -108.0738 * M_PI / 180, 1e-12);
  EXPECT_EQ(state.robot.status, c4g_driver::MotionStatus::kMoving);
  EXPECT_EQ(state.robot.motion, 13u);
  EXPECT_EQ(state.robot.waypoint, 7u);
  EXPECT_EQ(state.robot.outputs, 5u);
  EXPECT_EQ(state.robot.linear_speed, 0.1);
  EXPECT_EQ(state.robot.override, 100);
  EXPECT_EQ(state.robot.mode, c4g_driver::ControllerMode::kRemote);
  EXPECT_FALSE(state.robot.error);
  EXPECT_TRUE(state.robot.alarms.empty());
  EXPECT_TRUE(takes_motions(state.robot));
}

TEST(Parse, ReadsModesAndAlarmsAndWhetherTheControllerTakesMotions) {
  const auto changed = [](const json& changes) {
    json state = json::parse(kState);
    state.update(changes);
    return std::get<StreamedState>(parsed(state)).robot;
  };
  const json alarm = {{"code", 15}, {"text", "following error of J2"}};
  const auto alarmed = changed({{"alarms", json::array({alarm, alarm})}});
  ASSERT_EQ(alarmed.alarms.size(), 2u);
  EXPECT_EQ(alarmed.alarms[1].code, 15);
  EXPECT_EQ(alarmed.alarms[1].text, "following error of J2");
  EXPECT_FALSE(takes_motions(alarmed));
  EXPECT_EQ(changed({{"mode", "programming"}}).mode, c4g_driver::ControllerMode::kProgramming);
  EXPECT_TRUE(takes_motions(changed({{"mode", "programming"}})));
  EXPECT_EQ(changed({{"mode", "automatic"}}).mode, c4g_driver::ControllerMode::kAutomatic);
  EXPECT_FALSE(takes_motions(changed({{"mode", "automatic"}})));
  EXPECT_FALSE(takes_motions(changed({{"drives", false}})));
  EXPECT_FALSE(takes_motions(changed({{"e_stop", true}})));
}

TEST(Parse, ReadsAcknowledgements) {
  const auto good = std::get<Acknowledgement>(parsed(ack()));
  EXPECT_EQ(good.seq, 17u);
  EXPECT_FALSE(good.error);
  EXPECT_TRUE(good.robot);
  json refused = ack();
  refused["error"] = {{"code", 12}, {"text", "J3 5 deg is outside -170 .. 0"}};
  refused.erase("state");
  const auto bad = std::get<Acknowledgement>(parsed(refused));
  EXPECT_EQ(bad.error->code, 12);
  EXPECT_FALSE(bad.robot);
  json value = ack();
  value["value"] = {1, 2};
  EXPECT_EQ(std::get<Acknowledgement>(parsed(value)).value, "[1,2]");
}

TEST(Parse, NamesTheKeyThatIsMissing) {
  const json whole = json::parse(kState);
  for (const auto& [key, value] : whole.items()) {
    json state = whole;
    state.erase(key);
    EXPECT_NE(complaint(state.dump()).find(key), std::string::npos) << key;
  }
}

TEST(Parse, NamesTheKeyThatMakesNoSense) {
  const std::vector<std::pair<std::string, json>> changes = {
      {"c4g", 2},
      {"session", -1},
      {"session", "x"},
      {"type", "hello"},
      {"n", 1.5},
      {"t", -5},
      {"t", 1e18},
      {"pose", {1, 2, 3}},
      {"pose", "here"},
      {"joints", nullptr},
      {"status", "flying"},
      {"motion", -1},
      {"progress", 1.5},
      {"progress", "half"},
      {"waypoint", -1},
      {"waypoint", 1.5},
      {"outputs", -1},
      {"outputs", 1ull << 32},
      {"outputs", "on"},
      {"e_stop", 0},
      {"drives", "yes"},
      {"mode", "auto"},
      {"alarms", nullptr},
      {"alarms", json::array({7})},
      {"alarms", json::array({json{{"code", 1}}})},
      {"override", {}},
      {"linear_speed", 1e9},
      {"error", 7},
      {"error", {{"code", "x"}, {"text", ""}}}};
  for (const auto& [key, value] : changes) {
    json state = json::parse(kState);
    state[key] = value;
    const std::string what = complaint(state.dump());
    const bool named = what.find(key) != std::string::npos || (key == "c4g" && !what.empty()) ||
                       (key == "error" && what.find("code") != std::string::npos) ||
                       (key == "alarms" && what.find("text") != std::string::npos);
    EXPECT_TRUE(named) << key << " = " << value << ": " << what;
  }
  json pose = json::parse(kState);
  pose["pose"][2] = nullptr;  // how JSON libraries write NaN
  EXPECT_NE(complaint(pose.dump()).find("pose"), std::string::npos);
}

TEST(Parse, RefusesAnglesOutsideTheirRanges) {
  const auto with_angles = [](double a, double e, double r) {
    json state = json::parse(kState);
    state["pose"] = {800, 0, 600, a, e, r};
    return complaint(state.dump());
  };
  EXPECT_EQ(with_angles(180, 180, -180), "");
  EXPECT_EQ(with_angles(-180, 0, 180), "");
  EXPECT_NE(with_angles(180.001, 90, 0).find("pose A"), std::string::npos);
  EXPECT_NE(with_angles(400, 90, 0).find("pose A"), std::string::npos);
  EXPECT_NE(with_angles(0, 190, 0).find("pose E"), std::string::npos);
  EXPECT_NE(with_angles(0, -0.001, 0).find("pose E"), std::string::npos);
  EXPECT_NE(with_angles(0, 90, -180.001).find("pose R"), std::string::npos);
}

TEST(Parse, ReadsNumbersInEveryWayThatJsonWritesThem) {
  const auto progress = [](const std::string& number) {
    std::string text = kState;
    text.replace(text.find("0.42"), 4, number);
    return std::get<StreamedState>(c4g_driver::parse(c4g_driver::seal(text))).robot.progress;
  };
  EXPECT_EQ(progress("0E42"), 0);  // undefined in RapidJSON's full precision: found by the fuzzer
  EXPECT_EQ(progress("0.000e-400"), 0);
  EXPECT_EQ(progress("-0"), 0);
  EXPECT_EQ(progress("1e-999"), 0);
  for (const std::string number : {"0.1", "0.12345678901234567890123456789", "1e-1", "123.456e-3",
                                   "1234567890123456789012e-22", "2.5e-300"})
    EXPECT_NEAR(progress(number), std::stod(number), 1e-15 * std::stod(number)) << number;
}

TEST(Parse, RefusesNumbersThatOverflow) {
  std::string text = kState;
  text.replace(text.find("798.301"), 7, "1e999");
  EXPECT_NE(complaint(text), "");
}

TEST(Parse, SurvivesMutatedPackets) {
  std::mt19937 random(20261121);
  const std::vector<std::string> seeds = {json::parse(kState).dump(), ack().dump()};
  const auto draw = [&random](std::size_t below) {
    return std::uniform_int_distribution<std::size_t>(0, below - 1)(random);
  };
  int read = 0;
  for (int round = 0; round < 50000; ++round) {
    std::string text = seeds[draw(seeds.size())];
    for (std::size_t change = 0; change <= draw(4); ++change) {
      const std::size_t at = draw(text.size());
      switch (draw(4)) {
        case 0:
          text[at] = static_cast<char>(draw(256));
          break;
        case 1:
          text.erase(at, draw(20));
          break;
        case 2:
          text.insert(at, text.substr(draw(text.size()), draw(20)));
          break;
        default:
          text[at] = "0123456789-+.eE[]{},:\"\\nul"[draw(27)];
      }
      if (text.empty()) text = " ";
    }
    try {
      c4g_driver::parse(c4g_driver::seal(text));
      ++read;
    } catch (const ProtocolError&) {
    }
  }
  EXPECT_GT(read, 0);
  EXPECT_LT(read, 50000);
}

TEST(Parse, SurvivesRandomBytes) {
  std::mt19937 random(7);
  for (int round = 0; round < 20000; ++round) {
    std::string text(random() % 1500, '\0');
    for (char& byte : text)
      byte = static_cast<char>(random());
    EXPECT_THROW(c4g_driver::parse(text), ProtocolError);
    EXPECT_THROW(c4g_driver::parse(c4g_driver::seal(text + '}')), ProtocolError);
  }
  EXPECT_THROW(c4g_driver::parse(std::string(1400, '[')), ProtocolError);
  EXPECT_THROW(c4g_driver::parse(std::string(1401, ' ')), ProtocolError);
}
