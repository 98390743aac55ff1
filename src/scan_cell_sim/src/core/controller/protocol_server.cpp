// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/protocol_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "controller/wire/wire_json.h"

namespace scan_cell_sim {
namespace {

using nlohmann::json;
using Code = ControllerErrorCode;
using scan_cell_common::Nanoseconds;

constexpr int kVersion = 1;                            // c4g_protocol.md
constexpr Nanoseconds kClientSilence = 1'000'000'000;  // [ns] c4g_protocol.md
constexpr Nanoseconds kStreamTail = 200'000'000;       // [ns] c4g_protocol.md
constexpr Nanoseconds kMillisecond = 1'000'000;        // [ns]

/// [Hz]
double camera_rate(const json& request) {
  constexpr double kMost = 1e5;  // [Hz] c4g_protocol.md
  return number(entry(request, "camera_fps"), "camera_fps", 0, kMost);
}

/// [ns]
Nanoseconds watch_in(const json& request) {
  constexpr double kLeast = 20, kMost = 1000;  // [ms] c4g_protocol.md
  return kMillisecond *
         static_cast<Nanoseconds>(number(entry(request, "watch"), "watch", kLeast, kMost));
}

Eigen::Isometry3d pose_in(const json& request, const std::string& key) {
  return pose_from_wire(pose(entry(request, key), key));
}

void require_version(const json& request) {
  if (whole(entry(request, "c4g"), "c4g") != kVersion) {
    throw ControllerRefusal(Code::kVersion, "this controller speaks version 1");
  }
}

std::string command_of(const json& request) {
  return text(entry(request, "cmd"), "cmd");
}

/// @param what may quote a client; it is cut so that every answer fits into a datagram
json error_json(Code code, std::string what) {
  constexpr std::size_t kLongest = 80;  // characters; c4g_protocol.md
  what.resize(std::min(what.size(), kLongest));
  const auto odd = [](char byte) { return byte < ' ' || byte > '~'; };
  std::replace_if(what.begin(), what.end(), odd, '?');
  return {{"code", static_cast<int>(code)}, {"text", what}};
}

json alarms_json(const std::vector<Complaint>& alarms) {
  json list = json::array();
  for (const Complaint& alarm : alarms)
    list.push_back(error_json(alarm.code, alarm.text));
  return list;
}

}  // namespace

ProtocolServer::ProtocolServer(MotionControl& motion, const DriftingClock& clock,
                               const ControllerOptions& options)
    : motion_(motion),
      clock_(clock),
      parameters_(motion, options.stream_period),
      noise_(options.noise),
      random_(noise_.seed),
      witness_(options.witness) {}

std::optional<std::string> ProtocolServer::answer(const Datagram& datagram, Nanoseconds now) {
  const Peer& from = datagram.peer;
  const std::optional<json> packet = unsealed(datagram.text);
  if (!packet) return {};
  const json& request = *packet;
  const auto numbered = [&request](const char* key) {
    return request.contains(key) && request[key].is_number_unsigned();
  };
  if (!numbered("seq") || !numbered("session")) return {};
  json head = {{"c4g", kVersion},
               {"session", request["session"]},
               {"type", "ack"},
               {"seq", request["seq"]},
               {"error", nullptr}};
  try {
    const json result = reply(request, datagram, now);
    if (result.is_string()) return result.get<std::string>();  // a retry: the same answer again
    head.update(result);
  } catch (const ControllerRefusal& refusal) {
    head["error"] = error_json(refusal.code(), refusal.what());
  }
  const bool ours = client_ && from == *client_ && head["session"] == session_;
  if (ours) head["state"] = state(motion_.state(now), now);
  const std::string sent = sealed(head);
  if (ours && head["seq"] == last_seq_ && last_answer_.empty()) last_answer_ = sent;
  return sent;
}

json ProtocolServer::reply(const json& request, const Datagram& datagram, Nanoseconds now) {
  const Peer& from = datagram.peer;
  const std::uint64_t session = whole(entry(request, "session"), "session");
  const std::uint64_t seq = whole(entry(request, "seq"), "seq");
  if (!client_ || !(from == *client_) || session != session_) {
    open(request, session, seq, from, now);
  }
  last_heard_ = now;
  if (seq == last_seq_ && !last_answer_.empty()) return last_answer_;
  if (seq <= last_seq_) {
    throw ControllerRefusal(Code::kStraggler,
                            fmt::format("request {} came after {}", seq, last_seq_));
  }
  if (seq - last_seq_ > 1) {
    throw ControllerRefusal(
        Code::kOutOfTurn,
        fmt::format("request {} is out of turn, the next is {}", seq, last_seq_ + 1));
  }
  last_seq_ = seq;
  last_answer_.clear();
  return take_up(request, datagram.text, now);
}

json ProtocolServer::take_up(const json& request, const std::string& datagram, Nanoseconds now) {
  TakenUp taken{session_, last_seq_, datagram, {}};
  const auto tell = [&] {
    if (witness_) witness_(taken);
  };
  try {
    json result = perform(request, now);
    tell();
    return result;
  } catch (const ControllerRefusal& refusal) {
    taken.refused = refusal.code();
    tell();
    throw;
  }
}

/// @throw ControllerRefusal if the request does not begin a session
void ProtocolServer::open(const json& request, std::uint64_t session, std::uint64_t seq,
                          const Peer& from, Nanoseconds now) {
  require_version(request);
  const bool opens = command_of(request) == "OPEN";
  if (client_ && !(from == *client_)) {
    throw ControllerRefusal(Code::kBusy, "another client has the controller");
  }
  if (!opens) throw ControllerRefusal(Code::kSession, "this session is not open");
  const auto latest = latest_sessions_.find(from);
  if (latest != latest_sessions_.end() && session <= latest->second) {
    throw ControllerRefusal(Code::kSession, "the session is not newer than the client's last one");
  }
  if (seq != 1) throw ControllerRefusal(Code::kOutOfTurn, "the seq of OPEN is 1");
  motion_.forget(now);
  client_ = from;
  session_ = latest_sessions_[from] = session;
  last_seq_ = 0;
  last_answer_.clear();
  streamed_ = 0;
  path_ = {};
}

/// @return whether the command begins a motion
bool ProtocolServer::begin_motion(const std::string& command, const json& request,
                                  Nanoseconds now) {
  if (command == "MOVE_CARTESIAN") {
    motion_.move_to_pose(last_seq_, pose_in(request, "pose"), camera_rate(request), now);
  } else if (command == "MOVE_CIRCULAR") {
    motion_.move_along_arc(last_seq_, pose_in(request, "via"), pose_in(request, "pose"),
                           camera_rate(request), now);
  } else if (command == "MOVE_JOINT") {
    motion_.move_to_joints(last_seq_, joints_from_wire(six(entry(request, "joints"), "joints")),
                           camera_rate(request), now);
  } else if (command == "FOLLOW_PATH") {
    const std::size_t first = path_.check(request);
    const Nanoseconds watch = watch_in(request);
    motion_.follow(last_seq_, path_.flange_to_tip(), path_.waypoints(), first, now);
    follow_watch_ = watch;
  } else {
    return false;
  }
  return true;
}

/// @return the answer, if the command is about loading a path
std::optional<json> ProtocolServer::load(const std::string& command, const json& request) {
  if (command == "LOAD_PATH") {
    path_ = LoadedPath(request);
  } else if (command == "PATH_PIECE") {
    path_.add(request);
  } else {
    return std::nullopt;
  }
  return json{{"value", {path_.waypoints().size(), path_.checksum()}}};
}

json ProtocolServer::perform(const json& request, Nanoseconds now) {
  require_version(request);
  const std::string command = command_of(request);
  if (auto loaded = load(command, request)) return *loaded;
  if (begin_motion(command, request, now)) {
    last_moving_ = now;  // the shortest motion is streamed too
  } else if (command == "STOP") {
    motion_.stop(std::nullopt, now);
  } else if (command == "SET_OVERRIDE") {
    parameters_.set("override", entry(request, "override"), now);
  } else if (command == "SET_LINSPEED") {
    parameters_.set("linear_speed", entry(request, "linear_speed"), now);
  } else if (command == "GET_PARAMETER") {
    return {{"value", parameters_.get(text(entry(request, "name"), "name"))}};
  } else if (command == "SET_PARAMETER") {
    parameters_.set(text(entry(request, "name"), "name"), entry(request, "value"), now);
  } else if (command == "SET_DRIVES") {
    motion_.switch_drives(truth(entry(request, "drives"), "drives"), Readiness::Source::kClient,
                          now);
  } else if (command == "RESET_ALARMS") {
    motion_.reset_alarms(Readiness::Source::kClient);
  } else if (command == "CLOSE") {
    motion_.forget(now);
    client_.reset();
  } else if (command == "OPEN") {
    if (last_seq_ != 1) throw ControllerRefusal(Code::kOutOfTurn, "this session is already open");
  } else if (command != "GET_STATIC_POSE") {
    throw ControllerRefusal(Code::kUnknownCommand, "unknown command " + command);
  }
  return json::object();
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
  json result = {{"t", clock_.microseconds(now)},
                 {"pose", shown(measured(truth.flange))},
                 {"joints", shown(truth.joints)},
                 {"status", name_of(truth.status)},
                 {"motion", truth.motion},
                 {"progress", truth.progress},
                 {"waypoint", truth.waypoint},
                 {"outputs", truth.outputs},
                 {"camera_fps", truth.camera_rate},
                 {"e_stop", truth.readiness.e_stop()},
                 {"drives", truth.readiness.drives()},
                 {"mode", name_of(truth.readiness.mode())},
                 {"override", parameters_.get("override")},
                 {"linear_speed", parameters_.get("linear_speed")},
                 {"error", nullptr},
                 {"alarms", alarms_json(truth.readiness.alarms())}};
  if (truth.why) result["error"] = error_json(truth.why->code, truth.why->text);
  return result;
}

void ProtocolServer::watch(Nanoseconds now) {
  if (!client_) return;
  const Nanoseconds silence = now - last_heard_;
  if (silence >= follow_watch_ && motion_.follows(now)) {
    motion_.stop(Complaint{Code::kSession, fmt::format("the client was silent for {} ms",
                                                       follow_watch_ / kMillisecond)},
                 now);
  }
  if (silence < kClientSilence) return;
  motion_.stop(Complaint{Code::kSession, "the client was silent for 1 s"}, now);
  client_.reset();
}

std::optional<std::string> ProtocolServer::stream(Nanoseconds now) {
  if (!client_) return {};
  const MotionState truth = motion_.state(now);
  if (truth.status == MotionStatus::kMoving) last_moving_ = now;
  if (now - last_moving_ > kStreamTail) return {};
  json datagram = state(truth, now);
  datagram.update(
      {{"c4g", kVersion}, {"session", session_}, {"type", "state"}, {"n", ++streamed_}});
  return sealed(datagram);
}

}  // namespace scan_cell_sim
