// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "wire/codec.h"

namespace c4g_driver {

/// The waypoints of a path, in order, in pieces that each fit into a datagram.
/// @param path its number
/// @throw scan_cell_common::UnusableInput naming a waypoint that c4g_protocol.md cannot represent
std::vector<PathPiece> pieces_of(const ToolMotion& motion, std::uint64_t path);

/// CRC-32 over the checksums of a path's datagrams, LOAD_PATH first; c4g_protocol.md.
class PathChecksum {
 public:
  /// @param datagram sealed
  void add(std::string_view datagram);
  std::uint32_t value() const;

  /// The controller's acknowledgement of what it has received.
  std::string confirmation(std::size_t waypoints) const;

 private:
  std::string seals_;
};

}  // namespace c4g_driver
