// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <mutex>

#include "scan_cell_common/pose/timed_pose.h"

namespace scan_cell_sim {

/// The controller's own clock: microseconds since its start, at a rate that may drift. Safe for use
/// from several threads.
class DriftingClock {
 public:
  using Nanoseconds = scan_cell_common::Nanoseconds;

  explicit DriftingClock(Nanoseconds start) : host_(start) {}

  std::int64_t microseconds(Nanoseconds host) const;

  /// The host time at which this clock showed, or will show, `microseconds`.
  Nanoseconds host(std::int64_t microseconds) const;

  /// Zero at `host`, at the current rate.
  void restart(Nanoseconds host);

  /// From `host` on the clock runs 1 + drift times as fast as the host's.
  void set_drift(double drift, Nanoseconds host);

 private:
  mutable std::mutex mutex_;
  Nanoseconds host_;
  double device_ = 0;  // [ns] at host_
  double drift_ = 0;
};

}  // namespace scan_cell_sim
