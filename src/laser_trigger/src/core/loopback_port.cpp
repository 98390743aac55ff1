// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "loopback_port.h"

#include <fmt/core.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

#include "scan_cell_common/net/endpoint.h"

namespace laser_trigger {
namespace {

using scan_cell_common::Endpoint;

/// Returns and clears the socket's pending error.
int pending_error(int socket) {
  int error = 0;
  socklen_t size = sizeof(error);
  getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size);
  return error;
}

}  // namespace

LoopbackPort::LoopbackPort(const std::string& host, std::uint16_t port)
    : name_(fmt::format("{}:{}", host, port)),
      socket_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  const sockaddr_in address = Endpoint::parse("loopback address", host, port).to_kernel();
  if (port == 0) throw scan_cell_common::InvalidParameter("loopback address", name_, "give a port");
  // Connected, so that a refusal (nobody listens) is reported on this socket.
  if (connect(socket_.number(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0)
    throw NoDevice(name_, std::strerror(errno), "check the address");
}

void LoopbackPort::write(std::uint8_t data) {
  pending_error(socket_.number());  // of an earlier datagram
  int error = send(socket_.number(), &data, 1, MSG_NOSIGNAL) == 1 ? 0 : errno;
  // On the loopback, a refusal has arrived before send() returns.
  if (error == 0) error = pending_error(socket_.number());
  if (error == ECONNREFUSED) {
    throw NoDevice(name_, "no trigger circuit listens", "start the simulator, or check the port");
  }
  if (error != 0) {
    throw scan_cell_common::ConnectionError(name_, std::strerror(error), "check the network");
  }
}

}  // namespace laser_trigger
