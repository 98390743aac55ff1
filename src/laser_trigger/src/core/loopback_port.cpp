// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "loopback_port.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace laser_trigger {
namespace {

/// The socket's pending error, and clears it.
int pending_error(int socket) {
  int error = 0;
  socklen_t size = sizeof(error);
  getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size);
  return error;
}

}  // namespace

LoopbackPort::LoopbackPort(const std::string& host, std::uint16_t port)
    : name_(host + ":" + std::to_string(port)) {
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  if (port == 0 || inet_pton(AF_INET, host.c_str(), &address.sin_addr) != 1) {
    throw scan_cell_common::InvalidParameter("loopback address", name_,
                                             "give an IPv4 address such as 127.0.0.1, and a port");
  }
  socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (socket_ < 0 ||
      connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof(address)) != 0) {
    const int error = errno;
    if (socket_ >= 0) close(socket_);
    throw NoDevice(name_, std::strerror(error), "check the address");
  }
}

LoopbackPort::~LoopbackPort() {
  close(socket_);
}

void LoopbackPort::write(std::uint8_t data) {
  pending_error(socket_);  // of an earlier datagram
  int error = send(socket_, &data, 1, MSG_NOSIGNAL) == 1 ? 0 : errno;
  // On the loopback the answer that nobody listens is there before send() returns.
  if (error == 0) error = pending_error(socket_);
  if (error == ECONNREFUSED) {
    throw NoDevice(name_, "no trigger circuit listens", "start the simulator, or check the port");
  }
  if (error != 0) {
    throw scan_cell_common::ConnectionError(name_, std::strerror(error), "check the network");
  }
}

}  // namespace laser_trigger
