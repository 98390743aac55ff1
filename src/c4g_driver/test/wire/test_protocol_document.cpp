// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The examples of c4g_protocol.md, read and written by client and controller.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "scan_cell_sim/controller/offline_controller.h"
#include "wire/codec.h"
#include "wire/path_pieces.h"
#include "wire/seal.h"

using nlohmann::json;

namespace {

/// The indented blocks that begin a packet, each as one line.
std::vector<std::string> examples() {
  std::ifstream file(PROTOCOL_DOCUMENT);
  std::vector<std::string> found;
  for (std::string line; std::getline(file, line);) {
    if (line.compare(0, 10, "    {\"c4g\"") == 0) {
      found.push_back(line.substr(4));
    } else if (line.compare(0, 6, "     \"") == 0 && !found.empty() && found.back().back() == ',') {
      found.back() += line.substr(4);
    }
  }
  return found;
}

std::vector<std::string> examples_with(const std::string& key) {
  std::vector<std::string> found;
  for (const std::string& example : examples()) {
    if (example.find(key) != std::string::npos) found.push_back(example);
  }
  return found;
}

std::string state_example() {
  return examples_with("\"type\": \"state\"").at(0);
}

json without_seal(const std::string& datagram) {
  json packet = json::parse(datagram);
  packet.erase("crc");
  return packet;
}

/// Looking down, with x against the base's x.
c4g_driver::ToolWaypoint waypoint(double x, double y, double z, double speed, double zone,
                                  std::uint32_t outputs) {
  c4g_driver::ToolWaypoint result;
  result.tip.translation() << x, y, z;
  result.tip.linear() = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  result.speed = speed;
  result.zone = zone;
  result.outputs = outputs;
  return result;
}

/// Checksum from the seals that the document shows.
std::uint32_t checksum() {
  c4g_driver::PathChecksum sum;
  for (const std::string& example : examples_with("\"path\""))
    if (example.find("FOLLOW_PATH") == std::string::npos) sum.add(example);
  return sum.value();
}

/// The document's requests, in order.
std::vector<c4g_driver::Request> requests() {
  using namespace c4g_driver;  // NOLINT
  Joints joints;
  joints << 0, 0, -M_PI / 2, 0, M_PI / 2, 0;
  Eigen::Isometry3d flange = Eigen::Isometry3d::Identity();
  flange.translation() << 0.8, 0.1, 0.6;
  flange.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  // from there clockwise round x = 0.8, y = 0, seen from above
  const Eigen::Translation3d out(0.8, 0, 0), back(-0.8, 0, 0);
  const auto turned = [&](double angle) {
    return out * Eigen::AngleAxisd(angle, -Eigen::Vector3d::UnitZ()) * back * flange;
  };
  return {
      Open{},
      ResetAlarms{},
      SetDrives{true},
      SetOverride{100},
      SetLinearSpeed{0.1},
      SetParameter{"motion_type", "\"linear\""},
      SetParameter{"interpolation", "\"linear\""},
      SetParameter{"user_frame", "[500, 0, 100, 0, 0, 90]"},
      GetParameter{"user_frame"},
      MoveJoint{joints, 0},
      Stop{},
      GetStaticPose{},
      MoveCartesian{flange, 100},
      MoveCircular{turned(M_PI / 2), turned(M_PI), 100},
      LoadPath{1, 4, Eigen::Isometry3d(Eigen::Translation3d(0, 0, 0.15))},
      PathPiece{
          1, 0, {waypoint(0.8, -0.1, 0.45, 0.05, 0, 0), waypoint(0.8, 0, 0.45, 0.05, 0.002, 1)}},
      PathPiece{1, 2, {waypoint(0.85, 0, 0.45, 0.1, 0, 1), waypoint(0.85, 0, 0.5, 0.1, 0, 0)}},
      FollowPath{1, 0, checksum(), 0.1},
      Close{}};
}

/// Expects equality within the rounding of computed numbers.
void expect_same(const json& written, const json& built) {
  for (const json& change : json::diff(written, built)) {
    const json::json_pointer where(change["path"].get<std::string>());
    ASSERT_EQ(change["op"], "replace") << written << built;
    ASSERT_TRUE(written.at(where).is_number()) << written << built;
    EXPECT_NEAR(written.at(where).get<double>(), built.at(where).get<double>(), 1e-9) << written;
  }
}

}  // namespace

TEST(ProtocolDocument, ShowsEveryRequestAsTheClientWritesIt) {
  const auto written = examples_with("\"cmd\"");
  const auto asked = requests();
  ASSERT_EQ(written.size(), asked.size());
  std::map<std::size_t, int> kinds;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    ++kinds[asked[i].index()];
    EXPECT_NO_THROW(c4g_driver::check_seal(written[i])) << written[i];
    expect_same(without_seal(written[i]),
                without_seal(c4g_driver::build(asked[i], 1790000000000000, i + 1)));
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<c4g_driver::Request>);
}

TEST(ProtocolDocument, ShowsRequestsThatTheControllerCarriesOut) {
  scan_cell_sim::OfflineController controller;
  scan_cell_common::Nanoseconds now = 0;
  for (const std::string& request : examples_with("\"cmd\"")) {
    now += 10'000'000'000;
    const auto answer = controller.answer(request, now);
    ASSERT_TRUE(answer) << request;
    const auto reply = c4g_driver::parse(*answer);
    const auto& acknowledgement = std::get<c4g_driver::Acknowledgement>(reply);
    EXPECT_FALSE(acknowledgement.error) << *answer;
    if (request.find("GET_PARAMETER") == std::string::npos) continue;
    EXPECT_EQ(json::parse(acknowledgement.value), (json{500.0, 0.0, 100.0, 0.0, 0.0, 90.0}));
  }
  EXPECT_EQ(controller.motions_begun(), 4u);
}

TEST(ProtocolDocument, ShowsAStateAndAcknowledgementsThatTheClientReads) {
  const auto state = std::get<c4g_driver::StreamedState>(c4g_driver::parse(state_example()));
  EXPECT_EQ(state.number, 1204u);
  EXPECT_EQ(state.robot.mode, c4g_driver::ControllerMode::kRemote);
  const json inner = without_seal(state_example());
  const auto acknowledgements = examples_with("\"type\": \"ack\"");
  ASSERT_EQ(acknowledgements.size(), 3u);
  for (std::string text : acknowledgements) {
    text.replace(text.find("{...}"), 5, inner.dump());
    text.replace(text.find(",\"crc\":..."), 10, "");
    const auto reply = c4g_driver::parse(c4g_driver::seal(text));
    EXPECT_TRUE(std::get<c4g_driver::Acknowledgement>(reply).robot) << text;
  }
}

TEST(ProtocolDocument, ShowsTheStateWithTheKeysThatTheControllerSends) {
  scan_cell_sim::OfflineController controller;
  const auto written = examples_with("\"cmd\"");
  for (std::size_t i = 0; i < 10; ++i)  // to the first MOVE
    controller.answer(written.at(i), 1'000'000'000);
  const auto streamed = controller.stream(1'100'000'000);
  ASSERT_TRUE(streamed);
  const json shown = json::parse(state_example());
  const json sent = json::parse(*streamed);
  for (const auto& [key, value] : shown.items())
    EXPECT_TRUE(sent.contains(key)) << key;
  for (const auto& [key, value] : sent.items())
    EXPECT_TRUE(shown.contains(key)) << key;
}

TEST(ProtocolDocument, ShowsTheChecksumOfItsPath) {
  std::ifstream file(PROTOCOL_DOCUMENT);
  const std::string page((std::istreambuf_iterator<char>(file)), {});
  std::string seals;
  for (const std::string& example : examples_with("\"path\"")) {
    if (example.find("FOLLOW_PATH") != std::string::npos) continue;
    seals += std::to_string(json::parse(example)["crc"].get<std::uint32_t>()) + ",";
  }
  EXPECT_NE(page.find("`" + seals + "`, " + std::to_string(checksum()) + "."), std::string::npos);
}
