// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/udp_socket.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "scan_cell_common/errors.h"

namespace scan_cell_sim::gige {

UdpSocket::UdpSocket(const std::string& address, std::uint16_t port, bool shared)
    : handle_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(port);
  const int on = 1;
  if (inet_pton(AF_INET, address.c_str(), &name.sin_addr) != 1) {
    close(handle_);
    throw scan_cell_common::InvalidParameter("camera address", address,
                                             "give an IPv4 address such as 127.0.0.1");
  }
  if (shared) setsockopt(handle_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
  if (bind(handle_, reinterpret_cast<const sockaddr*>(&name), sizeof(name)) == 0) return;
  const std::string reason = std::strerror(errno);
  close(handle_);
  throw scan_cell_common::ConnectionError(
      "camera on " + address + ":" + std::to_string(port), reason,
      "stop the other camera or simulator on this address, or give another one");
}

UdpSocket::~UdpSocket() {
  close(handle_);
}

bool UdpSocket::receive(std::vector<std::uint8_t>& bytes, sockaddr_in& peer) const {
  constexpr std::size_t kMost = 1500;
  socklen_t size = sizeof(peer);
  bytes.resize(kMost);
  const ssize_t count =
      recvfrom(handle_, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&peer), &size);
  if (count < 0) return false;
  bytes.resize(static_cast<std::size_t>(count));
  return true;
}

void UdpSocket::send(const std::vector<std::uint8_t>& bytes, const sockaddr_in& peer) const {
  sendto(handle_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&peer),
         sizeof(peer));
}

}  // namespace scan_cell_sim::gige
