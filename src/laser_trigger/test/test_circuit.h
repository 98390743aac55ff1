// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "laser_trigger/trigger_port.h"
#include "scan_cell_common/host_clock.h"

namespace laser_trigger {

/// Waits for a condition; false if it does not come.
inline bool wait_for(const std::function<bool()>& condition, double timeout = 20) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeout);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

/// A trigger circuit on a UDP port of its own, that writes down every byte with its arrival.
class TestCircuit {
 public:
  struct Write {
    std::int64_t time;  //!< [ns] host time
    std::uint8_t data;
  };

  TestCircuit() {
    socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    if (bind(socket_, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
        getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
      throw std::runtime_error("no port for the test's circuit");
    }
    port_ = ntohs(address.sin_port);
  }
  ~TestCircuit() { stop(); }

  /// Apart from the constructor, so that a test can fork before there is a thread.
  void start() {
    thread_ = std::thread([this] { listen(); });
  }
  void stop() {
    ending_ = true;
    if (thread_.joinable()) thread_.join();
    if (socket_ >= 0) close(socket_);
    socket_ = -1;
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
      pollfd wait = {socket_, POLLIN, 0};
      if (poll(&wait, 1, 10) != 1) continue;
      std::uint8_t bytes[2];
      if (recv(socket_, bytes, sizeof(bytes), 0) != 1) continue;
      const auto now = scan_cell_common::host_now();
      const std::lock_guard<std::mutex> lock(mutex_);
      writes_.push_back({now, bytes[0]});
    }
  }

  int socket_ = -1;
  std::uint16_t port_ = 0;
  std::atomic<bool> ending_{false};
  std::thread thread_;
  mutable std::mutex mutex_;
  std::vector<Write> writes_;
};

}  // namespace laser_trigger
