// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scan_cell_common/net/udp_socket.h"

namespace c4g_driver {

/// UDP to one peer. Datagrams from any other address or port, and datagrams that are too long, are
/// dropped and counted. One thread sends and one receives; receiving allocates nothing.
class PeerSocket {
 public:
  struct Received {
    std::string_view datagram;           //!< valid until the next one is received
    scan_cell_common::Nanoseconds time;  //!< host time at which the kernel received it
  };

  /// @param local_address of this machine's interface to the peer; 0.0.0.0: any
  /// @param address, port the peer's
  /// @throw scan_cell_common::InvalidParameter if an address is not IPv4, or the local one does not
  /// belong to this machine
  /// @throw scan_cell_common::ConnectionError if there are no sockets left
  PeerSocket(const std::string& local_address, const std::string& address, std::uint16_t port,
             std::size_t max_bytes);

  /// Returns false if the network refuses it now: an unplugged cable is not an error of this class.
  bool send(const std::string& datagram) const;

  /// The next datagram of the peer; none within `timeout` [s].
  std::optional<Received> receive(double timeout);

  std::uint64_t foreign() const { return foreign_; }    //!< datagrams from other senders
  std::uint64_t overlong() const { return overlong_; }  //!< datagrams that were too long

 private:
  std::optional<Received> take();

  std::vector<char> bytes_;  // of the datagram received last
  scan_cell_common::Endpoint peer_;
  scan_cell_common::UdpSocket socket_;
  std::atomic<std::uint64_t> foreign_{0};
  std::atomic<std::uint64_t> overlong_{0};
};

}  // namespace c4g_driver
