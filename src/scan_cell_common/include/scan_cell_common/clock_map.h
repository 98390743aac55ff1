// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "scan_cell_common/timed_pose.h"

namespace scan_cell_common {

/// Maps the clock of a device to the host's, from pairs of a device time and the host time at which
/// the message with it was received. A message is never early, so the pair with the least delay is
/// the best: the offset is the least (host - device) over a window, which also follows a slow
/// drift.
///
/// The mapped time is late by the least delay of the wire (tens of microseconds on a cable), not by
/// its jitter. Not safe for use from several threads at once.
class ClockMap {
 public:
  /// @param window how much device time the least delay is sought over [ns], above 0
  /// @throw InvalidParameter if it is not
  explicit ClockMap(Nanoseconds window);

  /// Takes a pair. A device time before the last one restarts the map: the device was restarted.
  void add(Nanoseconds device, Nanoseconds host);

  bool empty() const { return offsets_.empty(); }

  /// Host time [ns] of a device time.
  /// @throw Refused if no pair was added
  Nanoseconds to_host(Nanoseconds device) const;

 private:
  struct Offset {
    Nanoseconds device;
    Nanoseconds offset;
  };

  Nanoseconds window_;
  Nanoseconds last_device_ = 0;
  std::deque<Offset> offsets_;  // ascending in both: the front is the least of the window
};

}  // namespace scan_cell_common
