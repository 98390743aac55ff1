// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/controller/faulty_wire.h"

#include <algorithm>

namespace scan_cell_sim {

using scan_cell_common::Nanoseconds;

bool FaultyWire::drawn(double probability) {
  return probability > 0 && std::uniform_real_distribution<double>()(random_) < probability;
}

void FaultyWire::insert(const Item& item) {
  const auto later =
      std::upper_bound(items_.begin(), items_.end(), item,
                       [](const Item& one, const Item& other) { return one.due < other.due; });
  items_.insert(later, item);
}

void FaultyWire::put(const Datagram& datagram, const WireFaults& faults, Nanoseconds now) {
  if (faults.link_down || drawn(faults.lost)) return;
  const Nanoseconds delay =
      drawn(faults.delayed) ? scan_cell_common::from_seconds(faults.delay) : 0;
  insert({now + delay, datagram});
  if (drawn(faults.repeated)) insert({now + delay, datagram});
}

std::optional<Datagram> FaultyWire::take(Nanoseconds now) {
  if (items_.empty() || items_.front().due > now) return {};
  Datagram datagram = std::move(items_.front().datagram);
  items_.pop_front();
  return datagram;
}

std::optional<Nanoseconds> FaultyWire::next_due() const {
  if (items_.empty()) return {};
  return items_.front().due;
}

}  // namespace scan_cell_sim
