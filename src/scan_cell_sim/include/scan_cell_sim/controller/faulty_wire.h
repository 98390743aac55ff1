// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>
#include <random>

#include "scan_cell_common/timed_pose.h"
#include "scan_cell_sim/controller/datagram.h"

namespace scan_cell_sim {

/// What happens to datagrams on the wire, each by its own draw.
struct WireFaults {
  double lost = 0;         //!< probability
  double repeated = 0;     //!< probability
  double delayed = 0;      //!< probability; what is delayed is overtaken by what comes after it
  double delay = 0.01;     //!< [s]
  bool link_down = false;  //!< nothing passes
};

/// One direction of a wire that loses, repeats and reorders datagrams, the same ones for the same
/// seed. Not safe for use from several threads.
class FaultyWire {
 public:
  explicit FaultyWire(unsigned seed) : random_(seed) {}

  void put(const Datagram& datagram, const WireFaults& faults, scan_cell_common::Nanoseconds now);

  /// A datagram that is due, in the order of their due times.
  std::optional<Datagram> take(scan_cell_common::Nanoseconds now);

  /// When the next one is due; none where nothing is on its way.
  std::optional<scan_cell_common::Nanoseconds> next_due() const;

 private:
  struct Item {
    scan_cell_common::Nanoseconds due;
    Datagram datagram;
  };

  bool drawn(double probability);
  void insert(const Item& item);

  std::mt19937 random_;
  std::deque<Item> items_;  // ascending by due time
};

}  // namespace scan_cell_sim
