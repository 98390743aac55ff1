// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "scan_cell_common/pose/timed_pose.h"

namespace scan_cell_common {

/// Maps the clock of a device to the host's, from pairs of a device time and the host time at which
/// the message with it was received. A message is never early, so the pairs with the least delay
/// are the best, and the map is a line below all pairs. Its slope, the drift, is that of the lower
/// convex hull over a long history (Zhang, Liu and Xia, INFOCOM 2002). Its height is that of the
/// least delay in a short window.
///
/// The mapped time is late by the least delay of the network (tens of microseconds on a cable), not
/// by its jitter. If a clock is set, the map follows within the window. Allocates nothing. Not
/// thread-safe.
class ClockMap {
 public:
  /// Figures that describe the map.
  struct Figures {
    double drift = 0;          //!< the device's clock runs 1 + drift times as fast as the host's
    Nanoseconds residual = 0;  //!< median height above the line of the cells' least delays
    Nanoseconds history = 0;   //!< device time over which the drift was estimated
    unsigned steps = 0;        //!< how often a clock was set, which restarts the history
  };

  /// @param window device time [ns] over which the least delay is taken, above 0; the drift is
  /// estimated over sixteen times as much
  /// @throw InvalidParameter if the window is not above 0
  explicit ClockMap(Nanoseconds window);

  /// Adds a pair. A device time before the last one means that the device was restarted, and
  /// restarts the map.
  void add(Nanoseconds device, Nanoseconds host);

  bool empty() const { return count_ == 0; }  //!< whether no pair has been added yet

  /// Host time [ns] of a device time.
  /// @throw Refused if no pair has been added
  Nanoseconds to_host(Nanoseconds device) const;

  Figures figures() const;  //!< of the present map

 private:
  static constexpr std::size_t kCells = 64;

  /// The pair with the least delay in a stretch of device time.
  struct Cell {
    Nanoseconds number = 0;  // of the stretch
    double device = 0;       // [ns] since the reference
    double offset = 0;       // [ns] host - device, minus that of the reference
  };

  const Cell& cell(std::size_t i) const { return cells_[(first_ + i) % kCells]; }
  Cell& cell(std::size_t i) { return cells_[(first_ + i) % kCells]; }
  double above_line(const Cell& pair) const { return pair.offset - slope_ * pair.device; }
  void begin(Nanoseconds device, Nanoseconds host);
  void drop_before(double device);
  bool keep(const Cell& pair);
  void fit();
  double hull_slope() const;
  double least_since(double device) const;
  double median_residual() const;

  Nanoseconds window_;
  Nanoseconds reference_device_ = 0;
  Nanoseconds reference_offset_ = 0;
  Nanoseconds last_device_ = 0;
  std::array<Cell, kCells> cells_;  // a ring, ascending
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  double slope_ = 0;    // of the offset
  double height_ = 0;   // [ns] of the map's line at the reference: the least delay of the window
  double support_ = 0;  // [ns] the same of the whole history
  unsigned steps_ = 0;
};

}  // namespace scan_cell_common
