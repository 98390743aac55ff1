// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "wire/c4g_datagram_targets.h"

#include <nlohmann/json.hpp>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_sim/controller/offline_controller.h"
#include "wire/codec.h"
#include "wire/seal.h"

namespace {

using namespace scan_cell_common;

// as in c4g_protocol.md, not sealed: the fuzzer seals what it changed, so that it passes
const char* const kStreamed =
    R"({"c4g": 1, "session": 1790000000000000, "type": "state", "n": 1204, "t": 48123456,
"pose": [798.301, 42, 875.5, 0, 180, 180],
"joints": [-3.0117, -0.6729, -108.0738, 0, 72.5991, -3.0117],
"status": "moving", "motion": 13, "progress": 0.42, "waypoint": 7, "outputs": 5, "camera_fps": 100,
"e_stop": false, "drives": true, "mode": "remote", "override": 100, "linear_speed": 100,
"error": null, "alarms": []})";
const char* const kAcknowledged =
    R"({"c4g": 1, "session": 1790000000000000, "type": "ack", "seq": 18,
"error": {"code": 12, "text": "J3 5 deg is outside -170 .. 0"}, "value": [0, 1, 2, 3, 4, 5],
"state": {"t": 1, "pose": [-800.123, 1e2, 600, 33, 44, -55], "joints": [0, 0, -90, 0, 90, 0],
"status": "stopped", "motion": 0, "progress": 0E42, "waypoint": 0, "outputs": 4294967295,
"camera_fps": 0, "e_stop": true,
"drives": false, "mode": "programming", "override": 0.01, "linear_speed": 1500,
"error": {"code": 11, "text": "emergency stop"}, "alarms": [{"code": 11, "text": "emergency stop"},
{"code": 15, "text": "following error of J2"}]}})";

std::string sealed(const std::string& packet) {
  if (packet.empty()) throw ProtocolError("packet", "empty", "no more to say");
  return c4g_driver::seal(packet);
}

void check_state(const c4g_driver::RobotState& robot) {
  promise(robot.flange.matrix().allFinite() && robot.joints.allFinite(), "a pose that is no pose");
  const Eigen::Matrix3d& rotation = robot.flange.linear();
  const double off = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm();
  promise(off < 1e-9 && rotation.determinant() > 0, "not a rotation");
  promise(robot.controller_time >= 0, "a time before the controller's start");
  promise(robot.progress >= 0 && robot.progress <= 1, "progress");
  promise(std::isfinite(robot.override) && std::isfinite(robot.linear_speed) &&
              std::isfinite(robot.camera_rate),
          "a setting that is no number");
}

bool stands_once(const std::string& datagram, const std::string& key) {
  const std::size_t first = datagram.find(key);
  return first != std::string::npos && datagram.find(key, first + 1) == std::string::npos;
}

/// Compares with what another JSON library reads. For a repeated key each library picks its own
/// value, so there is nothing to compare.
void compare(const c4g_driver::StreamedState& state, const std::string& datagram) {
  const auto packet = nlohmann::json::parse(datagram);
  const auto same = [&](const char* key, double read, double unit) {
    if (!stands_once(datagram, "\"" + std::string(key) + "\"")) return;
    const double expected = packet[key].get<double>() * unit;
    promise(std::abs(read - expected) <= 1e-12 * std::abs(expected), key);
  };
  same("n", static_cast<double>(state.number), 1);
  same("t", static_cast<double>(state.robot.controller_time), 1e3);
  same("progress", state.robot.progress, 1);
  same("waypoint", static_cast<double>(state.robot.waypoint), 1);
  same("outputs", state.robot.outputs, 1);
  same("override", state.robot.override, 1);
  same("linear_speed", state.robot.linear_speed, 1e-3);
  if (!stands_once(datagram, "\"pose\"")) return;
  for (int i = 0; i < 3; ++i) {
    const double expected = packet["pose"][static_cast<std::size_t>(i)].get<double>() * 1e-3;
    promise(std::abs(state.robot.flange.translation()[i] - expected) < 1e-9, "pose");
  }
}

void read_as_driver(const std::string& datagram) {
  const c4g_driver::Reply reply = c4g_driver::parse(datagram);
  promise(nlohmann::json::accept(datagram), "what was taken is no JSON");
  if (const auto* streamed = std::get_if<c4g_driver::StreamedState>(&reply)) {
    check_state(streamed->robot);
    compare(*streamed, datagram);
  } else if (const auto& robot = std::get<c4g_driver::Acknowledgement>(reply).robot) {
    check_state(*robot);
  }
}

/// Checks that the driver can read an answer of the controller.
const c4g_driver::Acknowledgement check_answer(const std::string& datagram) {
  promise(datagram.size() <= c4g_driver::kMaxDatagramBytes, "an answer that is too long");
  try {
    read_as_driver(datagram);
    return std::get<c4g_driver::Acknowledgement>(c4g_driver::parse(datagram));
  } catch (const Error& error) {
    throw FuzzFault("the driver does not read the answer " + datagram + ": " + error.what());
  }
}

/// Checks that, whatever the request, the robot stays within its joint ranges and the answers are
/// readable.
void ask_controller(const std::string& datagram) {
  constexpr Nanoseconds kSecond = 1'000'000'000;
  scan_cell_sim::OfflineController controller;
  controller.answer(sealed(R"({"c4g":1,"session":100,"seq":1,"cmd":"OPEN"})"), kSecond);
  const auto answer = controller.answer(datagram, 2 * kSecond);
  if (!answer) throw ProtocolError("request", "not answered", "send what the protocol says");
  const auto acknowledgement = check_answer(*answer);
  const auto streamed = controller.stream(2 * kSecond + kSecond / 20);
  if (streamed) read_as_driver(*streamed);
  for (const Nanoseconds later : {2 * kSecond + kSecond / 20, 3 * kSecond, 1000 * kSecond}) {
    const auto state = controller.state(later);
    promise(scan_cell_sim::outside_limits(state.joints).empty(), "a joint outside its range");
    promise(state.flange.matrix().allFinite(), "a pose that is no pose");
  }
  if (!acknowledgement.error) return;
  promise(controller.motions_begun() == 0, "a motion that was refused, and begun");
  throw ProtocolError("request", acknowledgement.error->text.c_str(), "as it says");
}

/// Sends a path's only piece, whatever it contains, and follows the path if the controller has all
/// of it.
void ask_to_follow(const std::string& piece) {
  constexpr Nanoseconds kSecond = 1'000'000'000;
  scan_cell_sim::OfflineController controller;
  controller.answer(sealed(R"({"c4g":1,"session":100,"seq":1,"cmd":"OPEN"})"), kSecond);
  controller.answer(sealed(R"({"c4g":1,"session":100,"seq":2,"cmd":"LOAD_PATH","path":1,"size":2,)"
                           R"("tool":[0,0,150,0,0,0]})"),
                    kSecond);
  const auto answer = controller.answer(piece, kSecond);
  if (!answer) throw ProtocolError("piece", "not answered", "send what the protocol says");
  const auto loaded = check_answer(*answer);
  if (loaded.error) throw ProtocolError("piece", loaded.error->text.c_str(), "as it says");
  promise(controller.motions_begun() == 0, "a piece that moves the robot");
  const auto value = nlohmann::json::parse(loaded.value.empty() ? "[]" : loaded.value);
  if (value.size() != 2) throw ProtocolError("piece", "another request", "send a piece");
  const nlohmann::json begin = {{"c4g", 1},     {"session", 100},      {"seq", 4},
                                {"path", 1},    {"from", 0},           {"cmd", "FOLLOW_PATH"},
                                {"watch", 100}, {"checksum", value[1]}};
  const auto begun = check_answer(controller.answer(sealed(begin.dump()), kSecond).value());
  promise(controller.motions_begun() == (begun.error ? 0 : 1), "refused and begun, or neither");
  for (const Nanoseconds later : {kSecond + kSecond / 20, 2 * kSecond, 100'000 * kSecond}) {
    const auto state = controller.state(later);
    promise(scan_cell_sim::outside_limits(state.joints).empty(), "a joint outside its range");
    promise(state.flange.matrix().allFinite(), "a pose that is no pose");
    promise(state.waypoint <= 1, "a waypoint that is none");
  }
  promise(controller.state(100'000 * kSecond).outputs == 0, "outputs that stay on");
  if (begun.error) throw ProtocolError("path", begun.error->text.c_str(), "as it says");
}

std::vector<std::string> pieces() {
  const std::string head =
      R"({"c4g":1,"session":100,"seq":3,"cmd":"PATH_PIECE","path":1,"first":0,"waypoints":[)"
      R"([800,0,450,0,180,180,50,0,1],)";
  return {head + R"([850,0,450,0,180,180,50,0,3]]})", head + R"([800,60,450,10,170,180,0.1,5,0]]})",
          head + R"([800,0,450,0,180,90,1500,100,4294967295]]})"};
}

/// Checks that the driver writes what it was given, and that it fits.
void write_parameter(const std::string& text) {
  const std::size_t middle = text.find('|');
  if (middle == std::string::npos) throw ProtocolError("text", "no middle", "give one");
  const c4g_driver::SetParameter set{text.substr(0, middle), text.substr(middle + 1)};
  const std::string datagram = c4g_driver::build(set, 100, 2);
  promise(datagram.size() <= c4g_driver::kMaxDatagramBytes, "a request that is too long");
  c4g_driver::check_seal(datagram);
  const auto packet = nlohmann::json::parse(datagram);
  promise(packet["value"] == nlohmann::json::parse(set.value), "another value");
}

std::vector<std::string> requests() {
  const std::string head = R"({"c4g":1,"session":100,"seq":2,"cmd":)";
  return {R"({"c4g":1,"session":100,"seq":1,"cmd":"OPEN"})",
          head + R"("CLOSE"})",
          head + R"("MOVE_CARTESIAN","pose":[800,100,600,0,180,180],"camera_fps":100})",
          head + R"("MOVE_CARTESIAN","pose":[800,5,600,10,170,180],"camera_fps":0})",
          head + R"("MOVE_CIRCULAR","via":[850,50,600,0,180,180],)" +
              R"("pose":[800,100,600,0,180,90],"camera_fps":100})",
          head + R"("MOVE_CIRCULAR","via":[700,0,600,0,180,180],)" +
              R"("pose":[750,60,650,20,170,180],"camera_fps":0})",
          head + R"("MOVE_JOINT","joints":[0,0,-90,0,90,0],"camera_fps":0})",
          head + R"("LOAD_PATH","path":1,"size":2,"tool":[0,0,150,0,0,0]})",
          head + R"("STOP"})",
          head + R"("SET_OVERRIDE","override":50})",
          head + R"("SET_LINSPEED","linear_speed":100})",
          head + R"("GET_STATIC_POSE"})",
          head + R"("GET_PARAMETER","name":"joint_upper"})",
          head + R"("SET_PARAMETER","name":"motion_type","value":"joint"})",
          head + R"("SET_PARAMETER","name":"user_frame","value":[1,2,3,4,5,6]})",
          head + R"("SET_PARAMETER","name":"rotational_speed","value":90})",
          head + R"("SET_DRIVES","drives":true})",
          head + R"("RESET_ALARMS"})"};
}

const std::vector<std::string> kWords = {"\"c4g\"",
                                         "\"session\"",
                                         "\"seq\"",
                                         "\"cmd\"",
                                         "\"type\"",
                                         "\"ack\"",
                                         "\"state\"",
                                         "\"t\"",
                                         "\"n\"",
                                         "\"pose\"",
                                         "\"via\"",
                                         "\"joints\"",
                                         "\"status\"",
                                         "\"moving\"",
                                         "\"arrived\"",
                                         "\"error\"",
                                         "\"alarms\"",
                                         "\"mode\"",
                                         "\"remote\"",
                                         "\"MOVE_CARTESIAN\"",
                                         "\"MOVE_CIRCULAR\"",
                                         "\"MOVE_JOINT\"",
                                         "\"LOAD_PATH\"",
                                         "\"PATH_PIECE\"",
                                         "\"FOLLOW_PATH\"",
                                         "\"path\"",
                                         "\"first\"",
                                         "\"size\"",
                                         "\"waypoints\"",
                                         "\"checksum\"",
                                         "\"waypoint\"",
                                         "\"outputs\"",
                                         "\"OPEN\"",
                                         "\"value\"",
                                         "\"name\"",
                                         "\"override\"",
                                         "\"linear_speed\"",
                                         "\"camera_fps\"",
                                         "null",
                                         "true",
                                         "false",
                                         "{",
                                         "}",
                                         "[",
                                         "]",
                                         ",",
                                         ":",
                                         "\"",
                                         "{}",
                                         "[]",
                                         "[[",
                                         "-180",
                                         "360",
                                         "\\u0000",
                                         "\\ud800",
                                         "\xff",
                                         ",\"crc\":0}",
                                         "[1,2,3,4,5,6]"};

}  // namespace

std::vector<FuzzTarget> c4g_datagram_targets() {
  FuzzTarget raw;
  raw.name = "raw";
  raw.run = read_as_driver;
  raw.seeds = {sealed(kStreamed), sealed(kAcknowledged)};
  raw.words = kWords;
  FuzzTarget answers;
  answers.name = "answers";
  answers.run = [](const std::string& packet) { read_as_driver(sealed(packet)); };
  answers.seeds = {kStreamed, kAcknowledged};
  answers.words = kWords;
  FuzzTarget asked;
  asked.name = "requests";
  asked.run = [](const std::string& packet) { ask_controller(sealed(packet)); };
  asked.seeds = requests();
  asked.words = kWords;
  FuzzTarget paths;
  paths.name = "paths";
  paths.run = [](const std::string& packet) { ask_to_follow(sealed(packet)); };
  paths.seeds = pieces();
  paths.words = kWords;
  FuzzTarget parameters;
  parameters.name = "parameters";
  parameters.run = write_parameter;
  parameters.seeds = {"motion_type|\"linear\"", "user_frame|[1, 2.5, 3e1, 4, 5, 6]", "override|50",
                      "x|{\"a\": [null, true, \"b\"]}"};
  parameters.words = kWords;
  return {raw, answers, asked, paths, parameters};
}
