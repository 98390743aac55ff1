// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/net/udp_socket.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace scan_cell_common {
namespace {

bool switch_on(int socket, int option) {
  const int on = 1;
  return setsockopt(socket, SOL_SOCKET, option, &on, sizeof on) == 0;
}

}  // namespace

UdpSocket::UdpSocket(const Endpoint& local, const std::string& owner, const std::string& cure,
                     bool shared)
    : socket_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  if (number() < 0 || !switch_on(number(), SO_TIMESTAMPNS) ||
      (shared && !switch_on(number(), SO_REUSEADDR))) {
    throw ConnectionError("UDP socket of the " + owner, std::strerror(errno),
                          "close programs that hold too many sockets");
  }
  const sockaddr_in address = local.to_kernel();
  if (bind(number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw CannotBind(owner + " on " + local.text(), std::strerror(errno), cure);
  }
}

Endpoint UdpSocket::local() const {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  getsockname(number(), reinterpret_cast<sockaddr*>(&address), &size);
  return Endpoint::from_kernel(address);
}

bool UdpSocket::wait(double timeout) const {
  constexpr Nanoseconds kSecond = 1'000'000'000;
  const Nanoseconds left = from_seconds(std::max(0.0, timeout));
  const timespec time{static_cast<time_t>(left / kSecond), static_cast<long>(left % kSecond)};
  pollfd readable{number(), POLLIN, 0};
  return ppoll(&readable, 1, &time, nullptr) == 1;
}

bool UdpSocket::send(const void* data, std::size_t size, const Endpoint& to) const {
  const sockaddr_in address = to.to_kernel();
  return sendto(number(), data, size, MSG_NOSIGNAL, reinterpret_cast<const sockaddr*>(&address),
                sizeof address) == static_cast<ssize_t>(size);
}

}  // namespace scan_cell_common
