// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/loaded_path.h"

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <nlohmann/json.hpp>

#include "controller/wire/wire_json.h"
#include "scan_cell_common/pose/units.h"

namespace scan_cell_sim {
namespace {

using nlohmann::json;
using Code = ControllerErrorCode;

using scan_cell_common::kMillimetre;

std::uint64_t within(const json& request, const std::string& name, std::uint64_t least,
                     std::uint64_t most) {
  const std::uint64_t value = whole(entry(request, name), name);
  if (value >= least && value <= most) return value;
  throw ControllerRefusal(Code::kOutOfRange,
                          fmt::format("{} is outside {} .. {}", name, least, most));
}

/// x, y, z, A, E, R, speed, zone, outputs
TipWaypoint waypoint_of(const json& value, const std::string& name) {
  constexpr std::size_t kPose = 6, kSize = 9;
  constexpr double kLeastSpeed = 0.01, kMostSpeed = 1500, kMostZone = 100;  // c4g_protocol.md
  constexpr std::uint64_t kMostOutputs = 0xFFFFFFFF;
  if (!value.is_array() || value.size() != kSize) {
    throw ControllerRefusal(Code::kMalformed, name + " is not nine numbers");
  }
  TipWaypoint waypoint;
  waypoint.tip = pose_from_wire(pose(json(value.begin(), value.begin() + kPose), name));
  waypoint.speed = number(value[6], name + " speed", kLeastSpeed, kMostSpeed) * kMillimetre;
  waypoint.zone = number(value[7], name + " zone", 0, kMostZone) * kMillimetre;
  const std::uint64_t outputs = whole(value[8], name + " outputs");
  if (outputs > kMostOutputs) {
    throw ControllerRefusal(Code::kOutOfRange, name + " has more than 32 outputs");
  }
  waypoint.outputs = static_cast<std::uint32_t>(outputs);
  return waypoint;
}

}  // namespace

LoadedPath::LoadedPath(const json& request) {
  constexpr std::uint64_t kMostWaypoints = 10000;  // c4g_protocol.md
  number_ = within(request, "path", 1, UINT64_MAX);
  size_ = within(request, "size", 2, kMostWaypoints);
  flange_to_tip_ = pose_from_wire(pose(entry(request, "tool"), "tool"));
  seal(request);
}

void LoadedPath::require(const json& request) const {
  const std::uint64_t meant = whole(entry(request, "path"), "path");
  if (number_ != 0 && meant == number_) return;
  throw ControllerRefusal(Code::kNoPath, fmt::format("path {} is not loaded", meant));
}

void LoadedPath::add(const json& request) {
  require(request);
  const std::uint64_t first = whole(entry(request, "first"), "first");
  if (first != waypoints_.size()) {
    throw ControllerRefusal(Code::kNoPath, fmt::format("a piece from waypoint {} is out of turn, "
                                                       "the next is {}",
                                                       first, waypoints_.size()));
  }
  const json& list = entry(request, "waypoints");
  if (!list.is_array() || list.empty()) {
    throw ControllerRefusal(Code::kMalformed, "waypoints is not a list, or is empty");
  }
  if (list.size() > size_ - waypoints_.size()) {
    throw ControllerRefusal(Code::kNoPath, fmt::format("more than {} waypoints", size_));
  }
  std::vector<TipWaypoint> piece;
  for (const json& value : list)
    piece.push_back(waypoint_of(value, fmt::format("waypoint {}", first + piece.size())));
  waypoints_.insert(waypoints_.end(), piece.begin(), piece.end());
  seal(request);
}

std::size_t LoadedPath::check(const json& request) const {
  require(request);
  if (waypoints_.size() < size_) {
    throw ControllerRefusal(Code::kNoPath, fmt::format("only {} of {} waypoints were loaded",
                                                       waypoints_.size(), size_));
  }
  if (whole(entry(request, "checksum"), "checksum") != checksum()) {
    throw ControllerRefusal(Code::kNoPath, fmt::format("the checksum is {}", checksum()));
  }
  return within(request, "from", 0, size_ - 2);
}

void LoadedPath::seal(const json& request) {
  seals_ += request["crc"].dump() + ",";
}

std::uint32_t LoadedPath::checksum() const {
  boost::crc_32_type crc;
  crc.process_bytes(seals_.data(), seals_.size());
  return crc.checksum();
}

}  // namespace scan_cell_sim
