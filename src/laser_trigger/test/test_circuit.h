// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "laser_trigger/trigger_port.h"
#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/net/udp_socket.h"

namespace laser_trigger {

/// Waits for a condition; false if it does not become true.
inline bool wait_for(const std::function<bool()>& condition, double timeout = 20) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeout);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

/// A trigger circuit on its own UDP port that records every byte with its arrival.
class TestCircuit {
 public:
  struct Write {
    std::int64_t time;  //!< [ns] host time
    std::uint8_t data;
  };

  ~TestCircuit() { stop(); }

  /// Separate from the constructor, so that a test can fork before there is a thread.
  void start() {
    thread_ = std::thread([this] { listen(); });
  }
  void stop() {
    ending_ = true;
    if (thread_.joinable()) thread_.join();
    socket_.reset();
  }

  PortAddress address() const { return PortAddress::loopback("127.0.0.1", port_); }

  std::vector<Write> writes() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return writes_;
  }
  /// The register's present value; 255 if nothing was ever written.
  std::uint8_t data() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return writes_.empty() ? 255 : writes_.back().data;
  }
  /// Arrival of each rising edge of the camera's line.
  std::vector<std::int64_t> rising_edges() const {
    std::vector<std::int64_t> edges;
    std::uint8_t before = 0;
    for (const Write& write : writes()) {
      if ((write.data & kCameraPulse) != 0 && (before & kCameraPulse) == 0) {
        edges.push_back(write.time);
      }
      before = write.data;
    }
    return edges;
  }

 private:
  void listen() {
    while (!ending_) {
      constexpr double kLook = 0.01;  // [s] between two checks of ending_
      if (!socket_->wait(kLook)) continue;
      std::uint8_t bytes[2];
      const auto datagram = socket_->receive(bytes, sizeof(bytes));
      if (!datagram || datagram->size != 1) continue;
      const auto now = scan_cell_common::host_now();
      const std::lock_guard<std::mutex> lock(mutex_);
      writes_.push_back({now, bytes[0]});
    }
  }

  std::optional<scan_cell_common::UdpSocket> socket_{
      std::in_place, scan_cell_common::Endpoint::parse("test", "127.0.0.1", 0), "test's circuit",
      ""};
  const std::uint16_t port_ = socket_->local().port;
  std::atomic<bool> ending_{false};
  std::thread thread_;
  mutable std::mutex mutex_;
  std::vector<Write> writes_;
};

}  // namespace laser_trigger
