// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "scan_cell_common/pose/timed_pose.h"

namespace tecnogamma_camera {

/// Unwraps a device's 32 bit clock. The host's clock says how often it wrapped since the last
/// frame, so a pause may be longer than a turn (72 minutes at 1 us); the two must agree to half a
/// turn.
class TickClock {
 public:
  /// @param tick [ns] above 0
  explicit TickClock(double tick) : tick_(tick) {}

  /// Time [ns] of a raw value that was received at `host` [ns]; never 0.
  scan_cell_common::Nanoseconds unwrap(std::uint32_t raw, scan_cell_common::Nanoseconds host);

  /// The next value is the first again.
  void reset() { started_ = false; }

 private:
  double tick_;
  bool started_ = false;
  std::int64_t last_ticks_ = 0;
  scan_cell_common::Nanoseconds last_host_ = 0;
};

}  // namespace tecnogamma_camera
