// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <tuple>

namespace scan_cell_sim {

/// Address and port of a client.
struct Peer {
  std::uint32_t address = 0;  //!< network byte order
  std::uint16_t port = 0;     //!< network byte order

  bool operator==(const Peer& other) const {
    return address == other.address && port == other.port;
  }
  bool operator<(const Peer& other) const {
    return std::tie(address, port) < std::tie(other.address, other.port);
  }
};

/// What came from a peer, or goes to one.
struct Datagram {
  Peer peer;
  std::string text;
};

}  // namespace scan_cell_sim
