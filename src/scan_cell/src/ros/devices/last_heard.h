// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <mutex>

namespace scan_cell {

/// When something was last heard from. Thread-safe.
class LastHeard {
 public:
  void now() {
    const std::lock_guard<std::mutex> lock(mutex_);
    time_ = Clock::now();
    ever_ = true;
  }

  bool ever() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return ever_;
  }

  /// Time [s] since then.
  double age() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::chrono::duration<double>(Clock::now() - time_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  mutable std::mutex mutex_;
  Clock::time_point time_ = Clock::now();
  bool ever_ = false;
};

}  // namespace scan_cell
