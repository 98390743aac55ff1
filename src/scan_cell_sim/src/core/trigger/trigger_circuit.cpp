// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/trigger_circuit.h"

#include <algorithm>

#include "scan_cell_common/clock/host_clock.h"

namespace scan_cell_sim {
namespace {

using scan_cell_common::Endpoint;
using scan_cell_common::host_now;
using scan_cell_common::Nanoseconds;
using scan_cell_common::UdpSocket;

constexpr std::uint8_t kPulseBit = 1;  // of the data register

std::uint8_t lasers_in(std::uint8_t data) {
  return static_cast<std::uint8_t>(data >> 1 & 3);
}

UdpSocket open_socket(const Endpoint& endpoint) {
  return {endpoint, "trigger circuit",
          "stop the program that holds the port, or give another port"};
}

}  // namespace

TriggerCircuit::TriggerCircuit(const std::string& address, std::uint16_t port)
    : socket_(open_socket(Endpoint::parse("address of the trigger circuit", address, port))),
      endpoint_(socket_->local()) {
  thread_ = std::thread(&TriggerCircuit::listen, this);
}

TriggerCircuit::~TriggerCircuit() {
  set_power(false);
}

void TriggerCircuit::set_power(bool on) {
  const std::lock_guard<std::mutex> lock(power_mutex_);
  if (on == thread_.joinable()) return;
  if (on) {
    {
      const std::lock_guard<std::mutex> socket_lock(socket_mutex_);
      socket_ = open_socket(endpoint_);
    }
    thread_ = std::thread(&TriggerCircuit::listen, this);
  } else {
    ending_ = true;
    thread_.join();
    ending_ = false;
    const std::lock_guard<std::mutex> socket_lock(socket_mutex_);
    socket_.reset();
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
  constexpr double kLook = 0.05;  // [s] between two checks of ending_; chosen
  while (!ending_) {
    if (socket_->wait(kLook)) take_all();
  }
}

void TriggerCircuit::take_all() {
  const std::lock_guard<std::mutex> socket_lock(socket_mutex_);
  std::uint8_t data[2];
  while (socket_) {
    const auto datagram = socket_->receive(data, sizeof data);
    if (!datagram) return;
    if (datagram->size == 1) {
      write(data[0], datagram->receipt.value_or(host_now()));
    } else {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++state_.refused;
    }
  }
}

std::array<double, 2> TriggerCircuit::lit(Nanoseconds begin, Nanoseconds end) {
  take_all();
  const std::lock_guard<std::mutex> lock(mutex_);
  std::array<double, 2> shares = {0, 0};
  Nanoseconds until = end;
  for (auto change = changes_.rbegin(); change != changes_.rend() && until > begin; ++change) {
    const Nanoseconds from = std::max(change->time, begin);
    if (from >= until) continue;
    for (std::size_t laser = 0; laser < shares.size(); ++laser) {
      if ((change->lasers >> laser & 1) != 0)
        shares[laser] += static_cast<double>(until - from) / static_cast<double>(end - begin);
    }
    until = from;
  }
  return shares;
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
  if (lasers != state_.lasers) changes_.push_back({time, lasers});
  // [ns] a busy computer draws frames later: 1000 pending ones (CameraOptions::max_pending) at 50
  // ms each, and an exposure; chosen
  constexpr Nanoseconds kKept = 60'000'000'000;
  while (changes_.size() > 1 && changes_[1].time < time - kKept)
    changes_.pop_front();
  state_.lasers = lasers;
  const bool high = (data & kPulseBit) != 0;
  const bool rising = high && !state_.pulse_line;
  state_.pulse_line = high;
  return rising;
}

}  // namespace scan_cell_sim
