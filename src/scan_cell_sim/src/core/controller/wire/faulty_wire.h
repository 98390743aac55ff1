// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <limits>
#include <optional>
#include <random>

#include "controller/wire/datagram.h"
#include "scan_cell_common/pose/timed_pose.h"
#include "scan_cell_sim/controller/wire_faults.h"

namespace scan_cell_sim {

/// One direction of a wire with WireFaults. The same seed gives the same faults. Not safe for use
/// from several threads.
class FaultyWire {
 public:
  using Nanoseconds = scan_cell_common::Nanoseconds;

  explicit FaultyWire(unsigned seed) : random_(seed) {}

  /// Restarts the random numbers; datagrams in transit are not changed.
  void seed(unsigned seed) { random_.seed(seed); }

  void put(const Datagram& datagram, const WireFaults& faults, Nanoseconds now);

  /// A datagram that is due, in the order of their due times.
  std::optional<Datagram> take(Nanoseconds now);

  /// When the next datagram is due; none if none is in transit.
  std::optional<Nanoseconds> next_due() const;

 private:
  struct Item {
    Nanoseconds due;
    Datagram datagram;
  };

  bool drawn(double probability);
  std::size_t below(std::size_t end);
  void send(Datagram datagram, const WireFaults& faults, Nanoseconds now);
  void spoil(std::string& text, const WireFaults& faults);
  Nanoseconds due(const WireFaults& faults, Nanoseconds now);

  std::mt19937 random_;
  std::deque<Item> items_;  // ascending by due time
  Nanoseconds held_until_ = std::numeric_limits<Nanoseconds>::min();
};

}  // namespace scan_cell_sim
