// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "wire/peer_socket.h"

#include <chrono>

#include "scan_cell_common/clock/host_clock.h"

namespace c4g_driver {
namespace {

using scan_cell_common::Endpoint;
using scan_cell_common::InvalidParameter;
using scan_cell_common::UdpSocket;

UdpSocket open(const std::string& local_address) {
  try {
    return {Endpoint::parse("local address", local_address, 0), "driver", ""};
  } catch (const scan_cell_common::CannotBind& error) {
    throw InvalidParameter("local address", "'" + local_address + "' (" + error.value() + ")",
                           "give one of this machine's (ip address), or 0.0.0.0 for any");
  }
}

}  // namespace

PeerSocket::PeerSocket(const std::string& local_address, const std::string& address,
                       std::uint16_t port, std::size_t max_bytes)
    : bytes_(max_bytes),
      peer_(Endpoint::parse("controller address", address, port)),
      socket_(open(local_address)) {}

bool PeerSocket::send(const std::string& datagram) const {
  return socket_.send(datagram.data(), datagram.size(), peer_);
}

std::optional<PeerSocket::Received> PeerSocket::receive(double timeout) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  while (true) {
    if (auto received = take()) return received;
    const double left = timeout - std::chrono::duration<double>(Clock::now() - start).count();
    if (left <= 0) return std::nullopt;
    socket_.wait(left);
  }
}

std::optional<PeerSocket::Received> PeerSocket::take() {
  while (const auto datagram = socket_.receive(bytes_.data(), bytes_.size())) {
    if (datagram->from != peer_) {
      ++foreign_;
    } else if (datagram->cut) {
      ++overlong_;
    } else {
      // The kernel's time, so that a busy host does not make the datagram look late.
      return Received{{bytes_.data(), datagram->size},
                      datagram->receipt.value_or(scan_cell_common::host_now())};
    }
  }
  return std::nullopt;
}

}  // namespace c4g_driver
