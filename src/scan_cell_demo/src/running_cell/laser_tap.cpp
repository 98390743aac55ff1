// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "running_cell/laser_tap.h"

#include <algorithm>
#include <chrono>

#include "scan_cell_common/clock/host_clock.h"

namespace scan_cell_demo {

using scan_cell_common::Endpoint;
using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;

namespace {

constexpr std::uint8_t kLaserBits = 6;  // of the circuit's register

Endpoint on_loopback(std::uint16_t port) {
  return Endpoint::parse("address of the tap", "127.0.0.1", port);
}

}  // namespace

LaserTap::LaserTap(std::uint16_t listen, std::uint16_t circuit)
    : socket_(on_loopback(listen), "tap", "end the program that holds the port"),
      circuit_(on_loopback(circuit)),
      thread_(&LaserTap::listen, this) {}

LaserTap::~LaserTap() {
  ending_ = true;
  thread_.join();
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
  constexpr double kLook = 0.05;  // [s] between two looks at ending_; chosen
  while (!ending_) {
    if (!socket_.wait(kLook)) continue;
    std::uint8_t data = 0;
    const auto datagram = socket_.receive(&data, 1);
    if (!datagram || datagram->size != 1) continue;
    socket_.send(&data, 1, circuit_);  // a missing circuit does not matter here
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
