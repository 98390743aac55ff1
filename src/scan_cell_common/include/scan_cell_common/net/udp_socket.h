// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/net/descriptor.h"
#include "scan_cell_common/net/stamped_datagram.h"

namespace scan_cell_common {

/// A local address or port is not available: it is taken or not of this machine.
class CannotBind : public ConnectionError {
 public:
  using ConnectionError::ConnectionError;
};

/// A bound UDP socket whose datagrams carry the kernel's time of receipt. Only wait() blocks, and
/// nothing allocates. One thread may send while another receives.
class UdpSocket {
 public:
  /// @param local port 0: any free one, see local()
  /// @param owner, cure the socket's owner and the cure in errors
  /// @param shared others may bind the same address and port
  /// @throw CannotBind
  /// @throw ConnectionError if there are no sockets left
  UdpSocket(const Endpoint& local, const std::string& owner, const std::string& cure,
            bool shared = false);

  Endpoint local() const;                          //!< to which it is bound
  int number() const { return socket_.number(); }  //!< of the descriptor, for poll()

  /// @return whether a datagram waits, within `timeout` [s]
  bool wait(double timeout) const;

  /// @return none if no datagram waits
  std::optional<StampedDatagram> receive(void* data, std::size_t size) const {
    return receive_stamped(number(), data, size);
  }

  /// Returns false if the network does not accept it now.
  bool send(const void* data, std::size_t size, const Endpoint& to) const;

 private:
  Descriptor socket_;
};

}  // namespace scan_cell_common
