// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wire/drifting_clock.h"

#include <algorithm>
#include <cmath>

namespace scan_cell_sim {

using scan_cell_common::Nanoseconds;

namespace {

constexpr double kMicrosecond = 1000;  // [ns]

}  // namespace

std::int64_t DriftingClock::microseconds(Nanoseconds host) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const double device = device_ + static_cast<double>(host - host_) * (1 + drift_);
  return std::max<std::int64_t>(0, static_cast<std::int64_t>(device / kMicrosecond));
}

Nanoseconds DriftingClock::host(std::int64_t microseconds) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const double device = static_cast<double>(microseconds) * kMicrosecond;
  return host_ + std::llround((device - device_) / (1 + drift_));
}

void DriftingClock::restart(Nanoseconds host) {
  const std::lock_guard<std::mutex> lock(mutex_);
  host_ = host;
  device_ = 0;
}

void DriftingClock::set_drift(double drift, Nanoseconds host) {
  const std::lock_guard<std::mutex> lock(mutex_);
  device_ += static_cast<double>(host - host_) * (1 + drift_);
  host_ = host;
  drift_ = drift;
}

}  // namespace scan_cell_sim
