// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/udp_socket.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/host_clock.h"
#include "scan_cell_common/stamped_datagram.h"

namespace c4g_driver {
namespace {

using scan_cell_common::ConnectionError;
using scan_cell_common::host_now;
using scan_cell_common::InvalidParameter;
using scan_cell_common::receive_stamped;
using Clock = std::chrono::steady_clock;

/// @throw InvalidParameter naming what is no address
sockaddr_in socket_address(const std::string& what, const std::string& address,
                           std::uint16_t port) {
  sockaddr_in result{};
  result.sin_family = AF_INET;
  result.sin_port = htons(port);
  if (inet_pton(AF_INET, address.c_str(), &result.sin_addr) != 1) {
    throw InvalidParameter(what, "'" + address + "'", "give an IPv4 address such as 192.168.0.10");
  }
  return result;
}

}  // namespace

UdpSocket::UdpSocket(const std::string& local_address, const std::string& address,
                     std::uint16_t port, std::size_t most_bytes)
    : bytes_(most_bytes), peer_(socket_address("controller address", address, port)) {
  const sockaddr_in local = socket_address("local address", local_address, 0);
  socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int on = 1;
  if (socket_ < 0 || setsockopt(socket_, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on) != 0) {
    const std::string reason = std::strerror(errno);
    if (socket_ >= 0) close(socket_);
    throw ConnectionError("UDP socket", reason, "close programs that hold too many sockets");
  }
  if (bind(socket_, reinterpret_cast<const sockaddr*>(&local), sizeof local) != 0) {
    const std::string reason = std::strerror(errno);
    close(socket_);
    throw InvalidParameter("local address", "'" + local_address + "' (" + reason + ")",
                           "give one of this machine's (ip address), or 0.0.0.0 for any");
  }
}

UdpSocket::~UdpSocket() {
  close(socket_);
}

bool UdpSocket::send(const std::string& datagram) {
  return sendto(socket_, datagram.data(), datagram.size(), 0,
                reinterpret_cast<const sockaddr*>(&peer_),
                sizeof peer_) == static_cast<ssize_t>(datagram.size());
}

std::optional<UdpSocket::Received> UdpSocket::receive(double timeout) {
  const Clock::time_point deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(
                         std::chrono::duration<double>(std::max(timeout, 0.0)));
  while (true) {
    if (auto received = take()) return received;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return std::nullopt;
    pollfd readable{socket_, POLLIN, 0};
    poll(&readable, 1, static_cast<int>(left));
  }
}

std::optional<UdpSocket::Received> UdpSocket::take() {
  while (true) {
    const auto datagram = receive_stamped(socket_, bytes_.data(), bytes_.size());
    if (!datagram) return std::nullopt;
    const sockaddr_in& from = datagram->from;
    if (from.sin_addr.s_addr != peer_.sin_addr.s_addr || from.sin_port != peer_.sin_port) {
      ++foreign_;
    } else if (datagram->cut) {
      ++overlong_;
    } else {
      // The kernel's time, so that a busy host does not make the datagram look late.
      return Received{{bytes_.data(), datagram->size}, datagram->receipt.value_or(host_now())};
    }
  }
}

}  // namespace c4g_driver
