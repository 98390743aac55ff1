// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "frame/tick_clock.h"

#include <algorithm>
#include <cmath>

namespace tecnogamma_camera {

using scan_cell_common::Nanoseconds;

Nanoseconds TickClock::unwrap(std::uint32_t raw, Nanoseconds host) {
  constexpr std::int64_t kTurn = std::int64_t{1} << 32;  // ticks of a 32 bit counter
  std::int64_t ticks = kTurn + raw;                      // 0 would mean that the time is not known
  if (started_) {
    const double expected =
        static_cast<double>(last_ticks_) + static_cast<double>(host - last_host_) / tick_;
    const double turns = std::round((expected - raw) / static_cast<double>(kTurn));
    ticks = raw + kTurn * std::max<std::int64_t>(1, static_cast<std::int64_t>(turns));
  }
  started_ = true;
  last_ticks_ = ticks;
  last_host_ = host;
  return static_cast<Nanoseconds>(std::llround(static_cast<double>(ticks) * tick_));
}

}  // namespace tecnogamma_camera
