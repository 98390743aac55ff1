// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"
#include "wire/codec.h"
#include "wire/seal.h"
#include "wire/wire_units.h"

namespace c4g_driver {
namespace {

using nlohmann::json;
using scan_cell_common::Refused;

using scan_cell_common::kMillimetre;

constexpr double kMilliseconds = 1e3;  // in a second

json value_of(const SetParameter& set) {
  json value = json::parse(set.value, nullptr, false);
  if (value.is_discarded()) {
    throw Refused("value of " + set.name, "'" + set.value + "'",
                  "give JSON, such as 250, \"linear\" or [0, 0, 0, 0, 0, 0]");
  }
  return value;
}

json to_json(const ToolWaypoint& waypoint) {
  json numbers = to_wire(waypoint.tip);
  numbers.push_back(waypoint.speed / kMillimetre);
  numbers.push_back(waypoint.zone / kMillimetre);
  numbers.push_back(waypoint.outputs);
  return numbers;
}

struct Name {
  const char* operator()(const Open&) const { return "OPEN"; }
  const char* operator()(const Close&) const { return "CLOSE"; }
  const char* operator()(const MoveCartesian&) const { return "MOVE_CARTESIAN"; }
  const char* operator()(const MoveCircular&) const { return "MOVE_CIRCULAR"; }
  const char* operator()(const MoveJoint&) const { return "MOVE_JOINT"; }
  const char* operator()(const LoadPath&) const { return "LOAD_PATH"; }
  const char* operator()(const PathPiece&) const { return "PATH_PIECE"; }
  const char* operator()(const FollowPath&) const { return "FOLLOW_PATH"; }
  const char* operator()(const Stop&) const { return "STOP"; }
  const char* operator()(const SetOverride&) const { return "SET_OVERRIDE"; }
  const char* operator()(const SetLinearSpeed&) const { return "SET_LINSPEED"; }
  const char* operator()(const GetStaticPose&) const { return "GET_STATIC_POSE"; }
  const char* operator()(const GetParameter&) const { return "GET_PARAMETER"; }
  const char* operator()(const SetParameter&) const { return "SET_PARAMETER"; }
  const char* operator()(const SetDrives&) const { return "SET_DRIVES"; }
  const char* operator()(const ResetAlarms&) const { return "RESET_ALARMS"; }
};

struct Arguments {
  json operator()(const MoveCartesian& move) const {
    return {{"pose", to_wire(move.flange)}, {"camera_fps", move.camera_rate}};
  }
  json operator()(const MoveCircular& move) const {
    return {{"via", to_wire(move.via)},
            {"pose", to_wire(move.flange)},
            {"camera_fps", move.camera_rate}};
  }
  json operator()(const MoveJoint& move) const {
    return {{"joints", to_wire(move.joints)}, {"camera_fps", move.camera_rate}};
  }
  json operator()(const LoadPath& load) const {
    return {{"path", load.path}, {"size", load.size}, {"tool", to_wire(load.flange_to_tip)}};
  }
  json operator()(const PathPiece& piece) const {
    json waypoints = json::array();
    for (const ToolWaypoint& waypoint : piece.waypoints)
      waypoints.push_back(to_json(waypoint));
    return {{"path", piece.path}, {"first", piece.first}, {"waypoints", waypoints}};
  }
  json operator()(const FollowPath& follow) const {
    return {{"path", follow.path},
            {"from", follow.from},
            {"checksum", follow.checksum},
            {"watch", std::lround(follow.watch * kMilliseconds)}};
  }
  json operator()(const SetOverride& set) const { return {{"override", set.override}}; }
  json operator()(const SetLinearSpeed& set) const {
    return {{"linear_speed", set.speed / kMillimetre}};
  }
  json operator()(const GetParameter& get) const { return {{"name", get.name}}; }
  json operator()(const SetParameter& set) const {
    return {{"name", set.name}, {"value", value_of(set)}};
  }
  json operator()(const SetDrives& set) const { return {{"drives", set.on}}; }
  template <class Other>
  json operator()(const Other&) const {
    return json::object();
  }
};

}  // namespace

std::string name_of(const Request& request) {
  return std::visit(Name(), request);
}

std::string build(const Request& request, std::uint64_t session, std::uint64_t seq) {
  json packet = std::visit(Arguments(), request);
  packet["c4g"] = kProtocolVersion;
  packet["session"] = session;
  packet["seq"] = seq;
  packet["cmd"] = name_of(request);
  const std::string text = seal(packet.dump(-1, ' ', false, json::error_handler_t::replace));
  check_size(name_of(request) + " packet", text.size());
  return text;
}

void check_size(const std::string& what, std::size_t bytes) {
  if (bytes <= kMaxDatagramBytes) return;
  throw Refused(what, fmt::format("{} bytes", bytes),
                fmt::format("give a value of fewer than {} bytes", kMaxDatagramBytes));
}

}  // namespace c4g_driver
