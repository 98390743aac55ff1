// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <string>
#include <vector>

namespace scan_cell_sim::gige {

/// A bound UDP socket that never blocks.
class UdpSocket {
 public:
  /// @param port 0: any
  /// @param shared others may bind the same address and port
  /// @throw scan_cell_common::InvalidParameter if the address is no IPv4 address
  /// @throw scan_cell_common::ConnectionError if it cannot be bound
  UdpSocket(const std::string& address, std::uint16_t port, bool shared = false);
  ~UdpSocket();

  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  int handle() const { return handle_; }

  /// Puts a waiting datagram into `bytes`; false where none waits.
  bool receive(std::vector<std::uint8_t>& bytes, sockaddr_in& peer) const;

  /// What the network does not take is lost, as on any wire.
  void send(const std::vector<std::uint8_t>& bytes, const sockaddr_in& peer) const;

 private:
  int handle_;
};

}  // namespace scan_cell_sim::gige
