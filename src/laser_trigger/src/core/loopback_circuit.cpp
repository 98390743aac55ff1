// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "loopback_circuit.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>

#include "scan_cell_common/stamped_datagram.h"

namespace laser_trigger {

using scan_cell_common::ConnectionError;

namespace {

/// A socket whose datagrams carry the kernel's time of receipt.
/// @return -1 with errno where it cannot be had
int listening_socket(const std::string& host, std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  if (inet_pton(AF_INET, host.c_str(), &address.sin_addr) != 1) {
    errno = EINVAL;
    return -1;
  }
  const int on = 1;
  const int opened = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (setsockopt(opened, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on) == 0 &&
      bind(opened, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
    return opened;
  }
  const int error = errno;
  if (opened >= 0) close(opened);
  errno = error;
  return -1;
}

}  // namespace

LoopbackCircuit::LoopbackCircuit(const std::string& host, std::uint16_t port)
    : host_(host), socket_(listening_socket(host, port)) {
  if (socket_ < 0) {
    throw ConnectionError("trigger circuit on " + host + ":" + std::to_string(port),
                          std::strerror(errno),
                          "stop the simulator or whatever holds the port, or give another address");
  }
  sockaddr_in address{};
  socklen_t size = sizeof address;
  getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
  port_ = ntohs(address.sin_port);
}

LoopbackCircuit::~LoopbackCircuit() {
  close(socket_);
}

std::optional<LoopbackCircuit::Write> LoopbackCircuit::take(double timeout) {
  constexpr double kMilliseconds = 1e3;
  pollfd readable{socket_, POLLIN, 0};
  if (poll(&readable, 1, static_cast<int>(std::ceil(timeout * kMilliseconds))) != 1) return {};
  std::uint8_t data[2];
  const auto datagram = scan_cell_common::receive_stamped(socket_, data, sizeof data);
  if (!datagram) return {};
  if (datagram->size != 1) {
    ++refused_;
    return {};
  }
  if (!datagram->receipt)
    throw ConnectionError("the kernel", "gives no receive time stamps", "use Linux");
  return Write{data[0], *datagram->receipt};
}

}  // namespace laser_trigger
