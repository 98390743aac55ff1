// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/clock/host_clock.h"

#include <ctime>

namespace scan_cell_common {

Nanoseconds host_now() {
  timespec time{};
  clock_gettime(CLOCK_REALTIME, &time);
  return Nanoseconds{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace scan_cell_common
