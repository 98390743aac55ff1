// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "wire/path_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/crc.hpp>

#include "scan_cell_common/errors/errors.h"

namespace c4g_driver {
namespace {

using scan_cell_common::UnusableInput;

// limits of a path on the wire; c4g_protocol.md
constexpr std::size_t kMostWaypoints = 10000;
constexpr double kLeastSpeed = 1e-5, kMostSpeed = 1.5;  // [m/s]
constexpr double kMostZone = 0.1;                       // [m]

void check_range(double value, double least, double most, std::size_t waypoint,
                 const std::string& what, const std::string& unit) {
  if (value >= least && value <= most) return;
  throw UnusableInput(fmt::format("waypoint {}, {}", waypoint, what),
                      fmt::format("{:g} {}", value, unit),
                      fmt::format("give {:g} .. {:g}", least, most));
}

/// Bytes of the datagram with the longest session and sequence numbers.
std::size_t bytes_of(const PathPiece& piece) {
  return build(piece, UINT64_MAX, UINT64_MAX).size();
}

}  // namespace

std::vector<PathPiece> pieces_of(const ToolMotion& motion, std::uint64_t path) {
  const std::size_t size = motion.waypoints.size();
  if (size < 2 || size > kMostWaypoints) {
    throw UnusableInput("path", fmt::format("{} waypoints", size),
                        fmt::format("give 2 .. {}", kMostWaypoints));
  }
  const std::size_t empty = bytes_of({path, size, {}});
  std::vector<PathPiece> pieces;
  std::size_t room = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const ToolWaypoint& waypoint = motion.waypoints[i];
    check_range(waypoint.speed, kLeastSpeed, kMostSpeed, i, "speed", "m/s");
    check_range(waypoint.zone, 0, kMostZone, i, "zone", "m");
    const std::size_t more = bytes_of({path, size, {waypoint}}) - empty + 1;
    if (pieces.empty() || room < more) {
      pieces.push_back({path, i, {}});
      room = kMaxDatagramBytes - empty;
    }
    pieces.back().waypoints.push_back(waypoint);
    room -= std::min(room, more);
  }
  return pieces;
}

void PathChecksum::add(std::string_view datagram) {
  const std::size_t begin = datagram.rfind(':') + 1;
  seals_.append(datagram.substr(begin, datagram.size() - begin - 1)).append(",");
}

std::uint32_t PathChecksum::value() const {
  boost::crc_32_type crc;
  crc.process_bytes(seals_.data(), seals_.size());
  return crc.checksum();
}

std::string PathChecksum::confirmation(std::size_t waypoints) const {
  return fmt::format("[{},{}]", waypoints, value());
}

}  // namespace c4g_driver
