// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <rapidjson/document.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"
#include "wire/codec.h"
#include "wire/seal.h"
#include "wire/wire_units.h"

namespace c4g_driver {
namespace {

using scan_cell_common::ProtocolError;
using Pool = rapidjson::MemoryPoolAllocator<>;
using Document = rapidjson::GenericDocument<rapidjson::UTF8<>, Pool, Pool>;
using Json = Document::ValueType;

using scan_cell_common::kMillimetre;
constexpr double kMaxMagnitude = 1e5;  // mm, deg, %, frames/s: values beyond it are invalid

[[noreturn]] void refuse(const std::string& key, const std::string& value) {
  throw ProtocolError("C4G packet: " + key, value, "see c4g_protocol.md");
}

const Json& entry(const Json& packet, const char* key) {
  const auto found = packet.FindMember(key);
  if (found == packet.MemberEnd()) refuse(key, "missing");
  return found->value;
}

double number(const Json& value, const char* key) {
  if (!value.IsNumber()) refuse(key, "not a number");
  const double result = value.GetDouble();
  if (!(std::abs(result) <= kMaxMagnitude)) refuse(key, "out of range");
  return result;
}

std::uint64_t whole(const Json& packet, const char* key, std::uint64_t most) {
  const Json& value = entry(packet, key);
  if (!value.IsUint64()) refuse(key, "not a whole number");
  if (value.GetUint64() > most) refuse(key, "out of range");
  return value.GetUint64();
}

bool truth(const Json& packet, const char* key) {
  const Json& value = entry(packet, key);
  if (!value.IsBool()) refuse(key, "not true or false");
  return value.GetBool();
}

std::string_view text(const Json& packet, const char* key) {
  const Json& value = entry(packet, key);
  if (!value.IsString()) refuse(key, "not a text");
  return {value.GetString(), value.GetStringLength()};
}

WireSix six(const Json& packet, const char* key) {
  const Json& value = entry(packet, key);
  if (!value.IsArray() || value.Size() != 6) refuse(key, "not six numbers");
  WireSix result{};
  for (unsigned i = 0; i < 6; ++i)
    result[i] = number(value[i], key);
  return result;
}

/// Angles outside their ranges are not wrapped: a sender of such angles means something else.
WireSix pose(const Json& packet) {
  constexpr double kHalfTurn = 180;
  const WireSix wire = six(packet, "pose");
  if (std::abs(wire[3]) > kHalfTurn) refuse("pose A", "outside -180 .. 180");
  if (!(wire[4] >= 0 && wire[4] <= kHalfTurn)) refuse("pose E", "outside 0 .. 180");
  if (std::abs(wire[5]) > kHalfTurn) refuse("pose R", "outside -180 .. 180");
  return wire;
}

MotionStatus status(const Json& packet) {
  const std::string_view word = text(packet, "status");
  if (word == "idle") return MotionStatus::kIdle;
  if (word == "moving") return MotionStatus::kMoving;
  if (word == "arrived") return MotionStatus::kArrived;
  if (word == "stopped") return MotionStatus::kStopped;
  if (word == "error") return MotionStatus::kError;
  refuse("status", "none of idle, moving, arrived, stopped, error");
}

ControllerMode mode(const Json& packet) {
  const std::string_view word = text(packet, "mode");
  if (word == "programming") return ControllerMode::kProgramming;
  if (word == "automatic") return ControllerMode::kAutomatic;
  if (word == "remote") return ControllerMode::kRemote;
  refuse("mode", "none of programming, automatic, remote");
}

/// A setting that scales the robot's speed. At 0 it would never arrive.
double above_zero(const Json& packet, const char* key) {
  const double value = number(entry(packet, key), key);
  if (!(value > 0)) refuse(key, "not above 0");
  return value;
}

double percentage(const Json& packet, const char* key) {
  constexpr double kMost = 100 + 1e-6;  // some controllers compute it, with rounding
  const double value = above_zero(packet, key);
  if (value > kMost) refuse(key, "above 100");
  return value;
}

/// Texts go to terminals and logs, which a line feed or an escape code would corrupt, so every
/// character outside printable ASCII becomes a question mark.
void assign_printable(std::string_view said, boost::static_string<80>& shown) {
  for (const char c : said) {
    const auto byte = static_cast<unsigned char>(c);
    const bool within_a_character = (byte & 0xC0) == 0x80;  // of UTF-8, after its first byte
    if (within_a_character) continue;
    if (shown.size() == shown.max_size()) return;
    shown.push_back(byte >= ' ' && byte < 0x7F ? c : '?');
  }
}

ControllerError complaint(const Json& value) {
  constexpr std::uint64_t kMaxCode = 1'000'000;  // c4g_protocol.md goes to 22; chosen
  ControllerError result;
  result.code = static_cast<int>(whole(value, "code", kMaxCode));
  assign_printable(text(value, "text"), result.text);
  return result;
}

std::optional<ControllerError> error(const Json& packet) {
  const Json& value = entry(packet, "error");
  if (value.IsNull()) return std::nullopt;
  if (!value.IsObject()) refuse("error", "neither null nor an object");
  return complaint(value);
}

void read_alarms(const Json& packet, Alarms& alarms) {
  const Json& list = entry(packet, "alarms");
  if (!list.IsArray()) refuse("alarms", "not a list");
  if (list.Size() > Alarms::static_capacity) refuse("alarms", "more than four");
  for (const Json& alarm : list.GetArray()) {
    if (!alarm.IsObject()) refuse("alarms", "one is not an object");
    alarms.push_back(complaint(alarm));
  }
}

RobotState robot_state(const Json& packet) {
  constexpr std::uint64_t kMaxMicroseconds = 1ull << 52;  // 142 years; whole in a double
  RobotState state;
  state.controller_time =
      1000 * static_cast<scan_cell_common::Nanoseconds>(whole(packet, "t", kMaxMicroseconds));
  state.flange = pose_from_wire(pose(packet));
  state.joints = joints_from_wire(six(packet, "joints"));
  state.status = status(packet);
  state.motion = whole(packet, "motion", UINT64_MAX);
  state.progress = number(entry(packet, "progress"), "progress");
  if (state.progress < 0 || state.progress > 1) refuse("progress", "outside 0 .. 1");
  state.waypoint = whole(packet, "waypoint", UINT64_MAX);
  state.outputs = static_cast<std::uint32_t>(whole(packet, "outputs", UINT32_MAX));
  state.camera_rate = number(entry(packet, "camera_fps"), "camera_fps");
  state.e_stop = truth(packet, "e_stop");
  state.drives = truth(packet, "drives");
  state.mode = mode(packet);
  state.override = percentage(packet, "override");
  state.linear_speed = above_zero(packet, "linear_speed") * kMillimetre;
  state.error = error(packet);
  read_alarms(packet, state.alarms);
  return state;
}

/// The same JSON in printable ASCII: all other characters of its texts are written as \uXXXX.
std::string printable_json(const Json& value) {
  constexpr char kDelete = 0x7F;
  rapidjson::StringBuffer buffer;
  rapidjson::Writer<rapidjson::StringBuffer, rapidjson::UTF8<>, rapidjson::ASCII<>> writer(buffer);
  value.Accept(writer);
  std::string json = buffer.GetString();
  for (std::size_t at = json.find(kDelete); at != std::string::npos; at = json.find(kDelete, at))
    json.replace(at, 1, "\\u007F");
  return json;
}

Acknowledgement acknowledgement(const Json& packet) {
  Acknowledgement result;
  result.session = whole(packet, "session", UINT64_MAX);
  result.seq = whole(packet, "seq", UINT64_MAX);
  result.error = error(packet);
  const auto state = packet.FindMember("state");
  if (state != packet.MemberEnd()) {
    if (!state->value.IsObject()) refuse("state", "not an object");
    result.robot = robot_state(state->value);
  }
  const auto value = packet.FindMember("value");
  if (value != packet.MemberEnd()) result.value = printable_json(value->value);
  return result;
}

Reply reply(const Json& packet) {
  if (!packet.IsObject()) refuse("datagram", "not a JSON object");
  const std::uint64_t version = whole(packet, "c4g", UINT64_MAX);
  if (version != kProtocolVersion) {
    throw ProtocolError("C4G version", fmt::format("{}", version),
                        "use a controller program that speaks version 1");
  }
  const std::string_view type = text(packet, "type");
  if (type == "ack") return acknowledgement(packet);
  if (type != "state") refuse("type", "neither ack nor state");
  return StreamedState{whole(packet, "session", UINT64_MAX), whole(packet, "n", UINT64_MAX),
                       robot_state(packet)};
}

}  // namespace

// All memory of the parser is on the stack, as a datagram has no more values than bytes. Numbers
// are exact to a few units in the last place; RapidJSON's full precision is undefined for 0E42.
Reply parse(std::string_view datagram) {
  constexpr std::size_t kValues = (kMaxDatagramBytes + 1) * sizeof(Json);
  constexpr unsigned kFlags = rapidjson::kParseInsituFlag | rapidjson::kParseIterativeFlag |
                              rapidjson::kParseValidateEncodingFlag;
  if (datagram.size() > kMaxDatagramBytes) {
    refuse("length", fmt::format("{} bytes", datagram.size()));
  }
  check_seal(datagram);
  std::array<char, kMaxDatagramBytes + 1> text;
  *std::copy(datagram.begin(), datagram.end(), text.begin()) = '\0';
  if (std::strlen(text.data()) != datagram.size()) refuse("datagram", "not a JSON object");
  alignas(Json) std::array<char, 2 * kValues> values;
  alignas(Json) std::array<char, 4 * kValues> open_values;
  Pool pool(values.data(), values.size());
  Pool stack_pool(open_values.data(), open_values.size());
  Document packet(&pool, kValues, &stack_pool);
  if (packet.ParseInsitu<kFlags>(text.data()).HasParseError()) {
    refuse("datagram", "not a JSON object");
  }
  return reply(packet);
}

}  // namespace c4g_driver
