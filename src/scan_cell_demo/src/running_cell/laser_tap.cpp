// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "running_cell/laser_tap.h"

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

namespace scan_cell_demo {

using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;
using scan_cell_common::receive_stamped;

namespace {

constexpr std::uint8_t kLaserBits = 6;  // of the circuit's register

sockaddr_in on_loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

}  // namespace

LaserTap::LaserTap(std::uint16_t listen, std::uint16_t circuit)
    : socket_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)),
      circuit_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  const sockaddr_in here = on_loopback(listen), there = on_loopback(circuit);
  const int on = 1;
  if (setsockopt(socket_, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on) != 0 ||
      bind(socket_, reinterpret_cast<const sockaddr*>(&here), sizeof here) != 0 ||
      connect(circuit_, reinterpret_cast<const sockaddr*>(&there), sizeof there) != 0) {
    const std::string reason = std::strerror(errno);
    close(socket_);
    close(circuit_);
    throw scan_cell_common::ConnectionError("tap on 127.0.0.1:" + std::to_string(listen), reason,
                                            "end the program that holds the port");
  }
  thread_ = std::thread(&LaserTap::listen, this);
}

LaserTap::~LaserTap() {
  ending_ = true;
  thread_.join();
  close(socket_);
  close(circuit_);
}

std::uint8_t LaserTap::lasers() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return lasers_;
}

std::uint64_t LaserTap::switched_on() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return switched_on_;
}

bool LaserTap::wait_until_on(double timeout) const {
  std::unique_lock<std::mutex> lock(mutex_);
  return changed_.wait_for(lock, std::chrono::duration<double>(timeout),
                           [this] { return lasers_ != 0; });
}

std::optional<double> LaserTap::on_for(Nanoseconds since, double timeout) const {
  std::unique_lock<std::mutex> lock(mutex_);
  if (!changed_.wait_for(lock, std::chrono::duration<double>(timeout),
                         [this] { return lasers_ == 0; })) {
    return std::nullopt;
  }
  return scan_cell_common::to_seconds(std::max<Nanoseconds>(0, off_at_ - since));
}

void LaserTap::listen() {
  constexpr int kLook = 50;  // [ms] between two looks at ending_
  while (!ending_) {
    pollfd readable{socket_, POLLIN, 0};
    if (poll(&readable, 1, kLook) != 1) continue;
    std::uint8_t data = 0;
    const auto datagram = receive_stamped(socket_, &data, 1);
    if (!datagram || datagram->size != 1) continue;
    send(circuit_, &data, 1, MSG_NOSIGNAL);  // a circuit that is not there does not matter here
    take(data, datagram->receipt.value_or(host_now()));
  }
}

void LaserTap::take(std::uint8_t data, Nanoseconds time) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto lasers = static_cast<std::uint8_t>((data & kLaserBits) >> 1);
  if (lasers != 0 && lasers_ == 0) ++switched_on_;
  if (lasers == 0 && lasers_ != 0) off_at_ = time;
  lasers_ = lasers;
  changed_.notify_all();
}

}  // namespace scan_cell_demo
