// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/clock_map.h"

#include <string>

#include "scan_cell_common/errors.h"

namespace scan_cell_common {

ClockMap::ClockMap(Nanoseconds window) : window_(window) {
  if (window <= 0) {
    throw InvalidParameter("clock map window", std::to_string(window) + " ns", "give one above 0");
  }
}

void ClockMap::add(Nanoseconds device, Nanoseconds host) {
  if (!offsets_.empty() && device < last_device_) offsets_.clear();
  last_device_ = device;
  const Nanoseconds offset = host - device;
  while (!offsets_.empty() && offsets_.back().offset >= offset)
    offsets_.pop_back();
  offsets_.push_back({device, offset});
  while (offsets_.front().device < device - window_)
    offsets_.pop_front();
}

Nanoseconds ClockMap::to_host(Nanoseconds device) const {
  if (offsets_.empty()) {
    throw Refused("device clock", "no message received yet", "wait for the device's first message");
  }
  return device + offsets_.front().offset;
}

}  // namespace scan_cell_common
