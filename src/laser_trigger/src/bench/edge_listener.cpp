// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "edge_listener.h"

#include <chrono>

namespace laser_trigger {

using scan_cell_common::Nanoseconds;

EdgeListener::~EdgeListener() {
  stop();
}

void EdgeListener::start() {
  while (take()) {
  }
  edges_.clear();
  ending_ = false;
  thread_ = std::thread(&EdgeListener::listen, this);
}

std::vector<Nanoseconds> EdgeListener::stop() {
  ending_ = true;
  if (thread_.joinable()) thread_.join();
  return edges_;
}

void EdgeListener::listen() {
  constexpr std::chrono::milliseconds kLook(50);  // [ms] chosen: the kernel buffers 100 ms
  while (!ending_) {
    std::this_thread::sleep_for(kLook);
    while (take()) {
    }
  }
}

bool EdgeListener::take() {
  const auto write = circuit_.take();
  if (!write) return false;
  if ((write->data & kCameraPulse) != 0 && (data_ & kCameraPulse) == 0)
    edges_.push_back(write->time);
  data_ = write->data;
  return true;
}

}  // namespace laser_trigger
