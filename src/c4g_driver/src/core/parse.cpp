// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "c4g_driver/codec.h"
#include "c4g_driver/seal.h"
#include "c4g_driver/wire_units.h"
#include "scan_cell_common/errors.h"

namespace c4g_driver {
namespace {

using nlohmann::json;
using scan_cell_common::ProtocolError;

constexpr int kVersion = 1;
constexpr double kMillimetre = 1e-3;
constexpr double kMostMagnitude = 1e5;  // mm, deg, %, frames/s: beyond it is nonsense

[[noreturn]] void refuse(const std::string& key, const std::string& value) {
  throw ProtocolError("C4G packet: " + key, value, "see docs/c4g_protocol.md");
}

const json& entry(const json& packet, const char* key) {
  const auto found = packet.find(key);
  if (found == packet.end()) refuse(key, "missing");
  return *found;
}

double number(const json& value, const char* key) {
  if (!value.is_number()) refuse(key, "not a number");
  const auto result = value.get<double>();
  if (!(std::abs(result) <= kMostMagnitude)) refuse(key, "out of range");
  return result;
}

std::uint64_t whole(const json& packet, const char* key, std::uint64_t most) {
  const json& value = entry(packet, key);
  if (!value.is_number_unsigned()) refuse(key, "not a whole number");
  const auto result = value.get<std::uint64_t>();
  if (result > most) refuse(key, "out of range");
  return result;
}

bool truth(const json& packet, const char* key) {
  const json& value = entry(packet, key);
  if (!value.is_boolean()) refuse(key, "not true or false");
  return value.get<bool>();
}

std::string text(const json& packet, const char* key) {
  const json& value = entry(packet, key);
  if (!value.is_string()) refuse(key, "not a text");
  return value.get<std::string>();
}

WireSix six(const json& packet, const char* key) {
  const json& value = entry(packet, key);
  if (!value.is_array() || value.size() != 6) refuse(key, "not six numbers");
  WireSix result{};
  for (std::size_t i = 0; i < 6; ++i)
    result[i] = number(value[i], key);
  return result;
}

MotionStatus status(const json& packet) {
  const std::string word = text(packet, "status");
  if (word == "idle") return MotionStatus::Idle;
  if (word == "moving") return MotionStatus::Moving;
  if (word == "arrived") return MotionStatus::Arrived;
  if (word == "stopped") return MotionStatus::Stopped;
  if (word == "error") return MotionStatus::Error;
  refuse("status", "none of idle, moving, arrived, stopped, error");
}

ControllerMode mode(const json& packet) {
  const std::string word = text(packet, "mode");
  if (word == "programming") return ControllerMode::Programming;
  if (word == "automatic") return ControllerMode::Automatic;
  if (word == "remote") return ControllerMode::Remote;
  refuse("mode", "none of programming, automatic, remote");
}

ControllerError complaint(const json& value) {
  constexpr std::uint64_t kMostCode = 1'000'000;
  return {static_cast<int>(whole(value, "code", kMostCode)), text(value, "text")};
}

std::optional<ControllerError> error(const json& packet) {
  const json& value = entry(packet, "error");
  if (value.is_null()) return std::nullopt;
  if (!value.is_object()) refuse("error", "neither null nor an object");
  return complaint(value);
}

std::vector<ControllerError> alarms(const json& packet) {
  const json& list = entry(packet, "alarms");
  if (!list.is_array()) refuse("alarms", "not a list");
  std::vector<ControllerError> result;
  for (const json& alarm : list) {
    if (!alarm.is_object()) refuse("alarms", "one is not an object");
    result.push_back(complaint(alarm));
  }
  return result;
}

RobotState robot_state(const json& packet) {
  constexpr std::uint64_t kMostMicroseconds = 1ull << 52;  // 142 years; whole in a double
  RobotState state;
  state.controller_time =
      1000 * static_cast<scan_cell_common::Nanoseconds>(whole(packet, "t", kMostMicroseconds));
  state.flange = pose_from_wire(six(packet, "pose"));
  state.joints = joints_from_wire(six(packet, "joints"));
  state.status = status(packet);
  state.motion = whole(packet, "motion", UINT64_MAX);
  state.progress = number(entry(packet, "progress"), "progress");
  if (state.progress < 0 || state.progress > 1) refuse("progress", "outside 0 .. 1");
  state.camera_rate = number(entry(packet, "camera_fps"), "camera_fps");
  state.e_stop = truth(packet, "e_stop");
  state.drives = truth(packet, "drives");
  state.mode = mode(packet);
  state.override = number(entry(packet, "override"), "override");
  state.linear_speed = number(entry(packet, "linear_speed"), "linear_speed") * kMillimetre;
  state.error = error(packet);
  state.alarms = alarms(packet);
  return state;
}

Acknowledgement acknowledgement(const json& packet) {
  Acknowledgement result;
  result.session = whole(packet, "session", UINT64_MAX);
  result.seq = whole(packet, "seq", UINT64_MAX);
  result.error = error(packet);
  const auto state = packet.find("state");
  if (state != packet.end()) {
    if (!state->is_object()) refuse("state", "not an object");
    result.robot = robot_state(*state);
  }
  const auto value = packet.find("value");
  if (value != packet.end()) result.value = value->dump();
  return result;
}

}  // namespace

Reply parse(const std::string& datagram) {
  if (datagram.size() > kMostDatagramBytes) {
    refuse("length", std::to_string(datagram.size()) + " bytes");
  }
  check_seal(datagram);
  const json packet = json::parse(datagram, nullptr, false);
  if (!packet.is_object()) refuse("datagram", "not a JSON object");
  const std::uint64_t version = whole(packet, "c4g", UINT64_MAX);
  if (version != kVersion) {
    throw ProtocolError("C4G version", std::to_string(version),
                        "use a controller program that speaks version 1");
  }
  const std::string type = text(packet, "type");
  if (type == "ack") return acknowledgement(packet);
  if (type != "state") refuse("type", "neither ack nor state");
  return StreamedState{whole(packet, "session", UINT64_MAX), whole(packet, "n", UINT64_MAX),
                       robot_state(packet)};
}

}  // namespace c4g_driver
