// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/controller/protocol_server.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace scan_cell_sim {
namespace {

using nlohmann::json;
using Code = ControllerErrorCode;
using scan_cell_common::Nanoseconds;

constexpr int kVersion = 1;
constexpr Nanoseconds kClientSilence = 1'000'000'000;
constexpr Nanoseconds kStreamTail = 200'000'000;
constexpr double kPercent = 0.01;
constexpr double kMillimetre = 1e-3;
constexpr double kDegree = M_PI / 180;

double number(const json& value, const std::string& name, double least, double most) {
  if (!value.is_number()) throw ControllerRefusal(Code::Malformed, name + " is not a number");
  const auto result = value.get<double>();
  if (result >= least && result <= most) return result;
  throw ControllerRefusal(Code::OutOfRange,
                          name + " is outside " + json(least).dump() + " .. " + json(most).dump());
}

const json& entry(const json& request, const std::string& name) {
  const auto found = request.find(name);
  if (found == request.end()) throw ControllerRefusal(Code::Malformed, name + " is missing");
  return *found;
}

double number(const json& request, const char* name, double least, double most) {
  return number(entry(request, name), std::string(name), least, most);
}

std::string text(const json& value, const std::string& name) {
  if (!value.is_string()) throw ControllerRefusal(Code::Malformed, name + " is not a text");
  return value.get<std::string>();
}

WireSix six(const json& value, const std::string& name) {
  constexpr double kMost = 1e6;
  if (!value.is_array() || value.size() != 6) {
    throw ControllerRefusal(Code::Malformed, name + " is not six numbers");
  }
  WireSix result{};
  for (std::size_t i = 0; i < 6; ++i)
    result[i] = number(value[i], name, -kMost, kMost);
  return result;
}

std::uint64_t whole(const json& request, const char* name) {
  const json& value = entry(request, name);
  if (!value.is_number_unsigned()) {
    throw ControllerRefusal(Code::Malformed, std::string(name) + " is not a whole number");
  }
  return value.get<std::uint64_t>();
}

WireSix rounded(WireSix values, double linear, double angular, int first_angle) {
  for (int i = 0; i < 6; ++i) {
    const double unit = i < first_angle ? linear : angular;
    values[i] = std::round(values[i] / unit) * unit;
  }
  return values;
}

const char* name_of(MotionStatus status) {
  switch (status) {
    case MotionStatus::Idle:
      return "idle";
    case MotionStatus::Moving:
      return "moving";
    case MotionStatus::Arrived:
      return "arrived";
    case MotionStatus::Stopped:
      return "stopped";
    case MotionStatus::Error:
      return "error";
  }
  return "error";
}

json error_json(Code code, const std::string& what) {
  return {{"code", static_cast<int>(code)}, {"text", what}};
}

}  // namespace

std::int64_t DriftingClock::microseconds(Nanoseconds host) const {
  const double device = device_ + static_cast<double>(host - host_) * (1 + drift_);
  return std::max<std::int64_t>(0, static_cast<std::int64_t>(device / 1000));
}

void DriftingClock::set_drift(double drift, Nanoseconds host) {
  device_ += static_cast<double>(host - host_) * (1 + drift_);
  host_ = host;
  drift_ = drift;
}

ProtocolServer::ProtocolServer(MotionControl& motion, double stream_period,
                               const MeasurementNoise& noise, Nanoseconds start)
    : motion_(motion),
      stream_period_(stream_period),
      noise_(noise),
      random_(noise.seed),
      clock_(start) {}

std::optional<std::string> ProtocolServer::answer(const Datagram& datagram, Nanoseconds now) {
  const Peer& from = datagram.peer;
  const json request = json::parse(datagram.text, nullptr, false);
  if (!request.is_object() || !request.contains("seq") || !request.contains("session")) return {};
  json head = {{"c4g", kVersion},
               {"session", request["session"]},
               {"type", "ack"},
               {"seq", request["seq"]},
               {"error", nullptr}};
  try {
    const json result = reply(request, from, now);
    if (result.is_string()) return result.get<std::string>();  // a retry: the same answer again
    head.update(result);
  } catch (const ControllerRefusal& refusal) {
    head["error"] = error_json(refusal.code(), refusal.what());
  }
  const bool ours = client_ && from == *client_ && head["session"] == session_;
  if (ours) head["state"] = state(motion_.state(now), now);
  const std::string sent = head.dump(-1, ' ', false, json::error_handler_t::replace);
  if (ours && head["seq"] == last_seq_ && last_answer_.empty()) last_answer_ = sent;
  return sent;
}

json ProtocolServer::reply(const json& request, const Peer& from, Nanoseconds now) {
  if (entry(request, "c4g") != kVersion) {
    throw ControllerRefusal(Code::Version, "this controller speaks version 1");
  }
  const std::string command = text(entry(request, "cmd"), "cmd");
  const std::uint64_t session = whole(request, "session");
  const std::uint64_t seq = whole(request, "seq");
  const bool from_client = client_ && from == *client_;
  if (command == "OPEN" && !(from_client && session == session_)) open(request, from, now);
  if (!client_ || !(from == *client_) || session != session_) {
    throw ControllerRefusal(client_ && !(from == *client_) ? Code::Busy : Code::Session,
                            "this session is not open");
  }
  last_heard_ = now;
  if (seq == last_seq_ && !last_answer_.empty()) return last_answer_;
  if (seq <= last_seq_) {
    throw ControllerRefusal(Code::Straggler, "request " + std::to_string(seq) + " comes after " +
                                                 std::to_string(last_seq_));
  }
  last_seq_ = seq;
  last_answer_.clear();
  return perform(request, now);
}

void ProtocolServer::open(const json& request, const Peer& from, Nanoseconds now) {
  const std::uint64_t session = whole(request, "session");
  if (client_ && !(from == *client_)) {
    throw ControllerRefusal(Code::Busy, "another client has the controller");
  }
  if (client_ && session < session_) {
    throw ControllerRefusal(Code::Session, "an older session than the present one");
  }
  motion_.forget(now);
  client_ = from;
  session_ = session;
  last_seq_ = 0;
  last_answer_.clear();
  streamed_ = 0;
}

json ProtocolServer::perform(const json& request, Nanoseconds now) {
  constexpr double kMostRate = 1e5;
  const std::string command = request["cmd"].get<std::string>();
  if (command.compare(0, 4, "MOVE") == 0)
    last_moving_ = now;  // the shortest motion is streamed too
  if (command == "MOVE_CARTESIAN") {
    motion_.move_to_pose(last_seq_, pose_from_wire(six(entry(request, "pose"), "pose")),
                         number(request, "camera_fps", 0, kMostRate), now);
  } else if (command == "MOVE_JOINT") {
    motion_.move_to_joints(last_seq_, joints_from_wire(six(entry(request, "joints"), "joints")),
                           number(request, "camera_fps", 0, kMostRate), now);
  } else if (command == "STOP") {
    motion_.stop(std::nullopt, now);
  } else if (command == "SET_OVERRIDE") {
    set_parameter("override", entry(request, "override"), now);
  } else if (command == "SET_LINSPEED") {
    set_parameter("linear_speed", entry(request, "linear_speed"), now);
  } else if (command == "GET_PARAMETER") {
    return {{"value", get_parameter(text(entry(request, "name"), "name"))}};
  } else if (command == "SET_PARAMETER") {
    set_parameter(text(entry(request, "name"), "name"), entry(request, "value"), now);
  } else if (command == "CLOSE") {
    motion_.forget(now);
    client_.reset();
  } else if (command != "OPEN" && command != "GET_STATIC_POSE") {
    throw ControllerRefusal(Code::UnknownCommand, "unknown command " + command);
  }
  return json::object();
}

json ProtocolServer::get_parameter(const std::string& name) const {
  const MotionSettings settings = motion_.settings();
  if (name == "motion_type") return settings.in_joints ? "joint" : "linear";
  if (name == "interpolation") return settings.line.euler ? "euler" : "linear";
  if (name == "override") return settings.override / kPercent;
  if (name == "linear_speed") return settings.line.speed / kMillimetre;
  if (name == "linear_acceleration") return settings.line.acceleration / kMillimetre;
  if (name == "rotational_speed") return settings.line.rotational_speed / kDegree;
  if (name == "stream_period") return stream_period_ * 1000;
  if (name == "base_frame") return base_frame_;
  if (name == "tool_frame") return tool_frame_;
  if (name == "user_frame") return user_frame_;
  if (name == "model") return "smart5_six (simulated)";
  if (name == "joint_lower") return to_wire(joint_limits().lower);
  if (name == "joint_upper") return to_wire(joint_limits().upper);
  if (name == "joint_speed") return to_wire(joint_limits().speed);
  throw ControllerRefusal(Code::UnknownParameter, "no parameter " + name);
}

void ProtocolServer::set_parameter(const std::string& name, const json& value, Nanoseconds now) {
  MotionSettings settings = motion_.settings();
  if (name == "motion_type" || name == "interpolation") {
    const std::string word = text(value, name);
    const std::string other = name == "motion_type" ? "joint" : "euler";
    if (word != "linear" && word != other) {
      throw ControllerRefusal(Code::OutOfRange, name + " is linear or " + other);
    }
    (name == "motion_type" ? settings.in_joints : settings.line.euler) = word == other;
    motion_.set(settings, now);
  } else if (name == "base_frame") {
    base_frame_ = six(value, name);
  } else if (name == "tool_frame") {
    tool_frame_ = six(value, name);
  } else if (name == "user_frame") {
    user_frame_ = six(value, name);
  } else if (name == "override") {
    settings.override = number(value, name, 0.01, 100) * kPercent;
    motion_.set(settings, now);
  } else if (name == "linear_speed") {
    settings.line.speed = number(value, name, 0.01, 1500) * kMillimetre;
    motion_.set(settings, now);
  } else if (name == "linear_acceleration") {
    settings.line.acceleration = number(value, name, 10, 5000) * kMillimetre;
    motion_.set(settings, now);
  } else if (name == "rotational_speed") {
    settings.line.rotational_speed = number(value, name, 1, 180) * kDegree;
    motion_.set(settings, now);
  } else if (name == "stream_period") {
    stream_period_ = number(value, name, 2, 10) / 1000;
  } else {
    get_parameter(name);  // throws where there is none
    throw ControllerRefusal(Code::ReadOnly, name + " is read-only");
  }
}

Eigen::Isometry3d ProtocolServer::measured(const Eigen::Isometry3d& flange) {
  if (noise_.position <= 0 && noise_.orientation <= 0) return flange;
  std::normal_distribution<double> normal;
  Eigen::Vector3d shift;
  Eigen::Vector3d turn;
  for (int i = 0; i < 3; ++i) {
    shift[i] = noise_.position * normal(random_);
    turn[i] = noise_.orientation * normal(random_);
  }
  Eigen::Isometry3d result = flange;
  result.translation() += shift;
  if (turn.norm() > 0) result.rotate(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
  return result;
}

json ProtocolServer::state(const MotionState& truth, Nanoseconds now) {
  constexpr double kMicrometre = 1e-3;  // [mm]
  constexpr double kAngleStep = 1e-4;   // [deg]
  json result = {{"t", clock_.microseconds(now)},
                 {"pose", rounded(to_wire(measured(truth.flange)), kMicrometre, kAngleStep, 3)},
                 {"joints", rounded(to_wire(truth.joints), kAngleStep, kAngleStep, 0)},
                 {"status", name_of(truth.status)},
                 {"motion", truth.motion},
                 {"progress", truth.progress},
                 {"camera_fps", truth.camera_rate},
                 {"e_stop", truth.e_stop},
                 {"drives", !truth.e_stop},
                 {"mode", "auto"},
                 {"override", truth.settings.override / kPercent},
                 {"linear_speed", truth.settings.line.speed / kMillimetre},
                 {"error", nullptr}};
  if (truth.why) result["error"] = error_json(truth.why->code, truth.why->text);
  return result;
}

void ProtocolServer::watch(Nanoseconds now) {
  if (!client_ || now - last_heard_ < kClientSilence) return;
  motion_.stop(StopReason{Code::Session, "the client was silent for 1 s"}, now);
  client_.reset();
}

std::optional<std::string> ProtocolServer::stream(Nanoseconds now) {
  if (!client_) return {};
  const MotionState truth = motion_.state(now);
  if (truth.status == MotionStatus::Moving) last_moving_ = now;
  if (now - last_moving_ > kStreamTail) return {};
  json datagram = state(truth, now);
  datagram.update(
      {{"c4g", kVersion}, {"session", session_}, {"type", "state"}, {"n", ++streamed_}});
  return datagram.dump();
}

}  // namespace scan_cell_sim
