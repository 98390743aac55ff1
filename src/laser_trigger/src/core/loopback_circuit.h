// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "laser_trigger/trigger_port.h"
#include "scan_cell_common/net/udp_socket.h"

namespace laser_trigger {

/// The other end of a LoopbackPort, in place of the simulator's circuit: receives the register's
/// values. Not thread-safe.
class LoopbackCircuit {
 public:
  struct Write {
    std::uint8_t data = 0;                   //!< the register
    scan_cell_common::Nanoseconds time = 0;  //!< when the kernel received it, on host_now()'s clock
  };

  /// @param port 0: any free one
  /// @throw scan_cell_common::InvalidParameter if `host` is not an IPv4 address
  /// @throw scan_cell_common::ConnectionError if the address cannot be used, such as a taken port
  LoopbackCircuit(const std::string& host, std::uint16_t port);

  PortAddress address() const { return PortAddress::loopback(host_, socket_.local().port); }

  /// The next write, if one arrives within `timeout` [s]. Datagrams that are not one byte are
  /// counted and ignored.
  std::optional<Write> take(double timeout = 0);

  std::uint64_t refused() const { return refused_; }  //!< datagrams that were not one byte

 private:
  std::string host_;
  scan_cell_common::UdpSocket socket_;
  std::uint64_t refused_ = 0;
};

}  // namespace laser_trigger
