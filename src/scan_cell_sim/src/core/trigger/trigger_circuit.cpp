// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/trigger_circuit.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/host_clock.h"
#include "scan_cell_common/stamped_datagram.h"

namespace scan_cell_sim {
namespace {

using scan_cell_common::ConnectionError;
using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;
using scan_cell_common::receive_stamped;

constexpr std::uint8_t kPulseBit = 1;

std::uint8_t lasers_in(std::uint8_t data) {
  return static_cast<std::uint8_t>(data >> 1 & 3);
}

/// A socket whose datagrams carry the kernel's time of receipt.
int open_socket(const std::string& address, std::uint16_t port) {
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(port);
  const int on = 1;
  const int handle = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (inet_pton(AF_INET, address.c_str(), &name.sin_addr) == 1 &&
      setsockopt(handle, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof(on)) == 0 &&
      bind(handle, reinterpret_cast<const sockaddr*>(&name), sizeof(name)) == 0) {
    return handle;
  }
  const std::string reason = std::strerror(errno);
  if (handle >= 0) close(handle);
  throw ConnectionError("trigger circuit on " + address + ":" + std::to_string(port), reason,
                        "stop the program that holds the port, or give another one");
}

std::uint16_t port_of(int handle) {
  sockaddr_in name{};
  socklen_t size = sizeof(name);
  getsockname(handle, reinterpret_cast<sockaddr*>(&name), &size);
  return ntohs(name.sin_port);
}

}  // namespace

TriggerCircuit::TriggerCircuit(const std::string& address, std::uint16_t port)
    : address_(address), socket_(open_socket(address, port)), port_(port_of(socket_)) {
  thread_ = std::thread(&TriggerCircuit::listen, this);
}

TriggerCircuit::~TriggerCircuit() {
  set_power(false);
}

void TriggerCircuit::set_power(bool on) {
  const std::lock_guard<std::mutex> lock(power_mutex_);
  if (on == thread_.joinable()) return;
  if (on) {
    socket_ = open_socket(address_, port_);
    thread_ = std::thread(&TriggerCircuit::listen, this);
  } else {
    ending_ = true;
    thread_.join();
    ending_ = false;
    close(socket_);
    set_lines(0, host_now());
  }
}

void TriggerCircuit::observe(const Observer& observer) {
  const std::lock_guard<std::mutex> lock(observer_mutex_);
  observer_ = observer;
}

TriggerCircuit::State TriggerCircuit::state() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  State state = state_;
  const Nanoseconds now = host_now();
  for (int i = 0; i < 2; ++i) {
    if ((state.lasers >> i & 1) == 0) continue;
    state.longest_on[i] =
        std::max(state.longest_on[i], scan_cell_common::to_seconds(now - on_since_[i]));
  }
  return state;
}

void TriggerCircuit::listen() {
  constexpr int kPatience = 50;  // [ms] between two looks at ending_
  while (!ending_) {
    pollfd wait{socket_, POLLIN, 0};
    if (poll(&wait, 1, kPatience) <= 0) continue;
    std::uint8_t data[2];
    const auto datagram = receive_stamped(socket_, data, sizeof data);
    if (!datagram) continue;
    if (datagram->size == 1) {
      write(data[0], datagram->receipt.value_or(host_now()));
    } else {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++state_.refused;
    }
  }
}

void TriggerCircuit::write(std::uint8_t data, Nanoseconds time) {
  const bool rising = set_lines(data, time);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++state_.writes;
    if (rising) ++state_.pulses;
  }
  if (!rising) return;
  const std::lock_guard<std::mutex> lock(observer_mutex_);
  if (observer_) observer_({time, lasers_in(data)});
}

/// @return whether the camera's line rose
bool TriggerCircuit::set_lines(std::uint8_t data, Nanoseconds time) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::uint8_t lasers = lasers_in(data);
  for (int i = 0; i < 2; ++i) {
    const bool was_on = (state_.lasers >> i & 1) != 0;
    const bool is_on = (lasers >> i & 1) != 0;
    if (is_on && !was_on) on_since_[i] = time;
    if (!is_on && was_on) {
      state_.longest_on[i] =
          std::max(state_.longest_on[i], scan_cell_common::to_seconds(time - on_since_[i]));
    }
  }
  state_.lasers = lasers;
  const bool high = (data & kPulseBit) != 0;
  const bool rising = high && !state_.pulse_line;
  state_.pulse_line = high;
  return rising;
}

}  // namespace scan_cell_sim
