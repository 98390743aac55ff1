// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wire/faulty_wire.h"

#include <algorithm>

namespace scan_cell_sim {

using scan_cell_common::from_seconds;
using scan_cell_common::Nanoseconds;

bool FaultyWire::drawn(double probability) {
  return probability > 0 && std::uniform_real_distribution<double>()(random_) < probability;
}

std::size_t FaultyWire::below(std::size_t end) {
  return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
}

void FaultyWire::put(const Datagram& datagram, const WireFaults& faults, Nanoseconds now) {
  if (faults.link_down || drawn(faults.lost)) return;
  send(datagram, faults, now);
  if (drawn(faults.repeated)) send(datagram, faults, now);
}

void FaultyWire::send(Datagram datagram, const WireFaults& faults, Nanoseconds now) {
  spoil(datagram.text, faults);
  const Nanoseconds time = due(faults, now);
  const auto later =
      std::upper_bound(items_.begin(), items_.end(), time,
                       [](Nanoseconds one, const Item& other) { return one < other.due; });
  items_.insert(later, {time, std::move(datagram)});
}

void FaultyWire::spoil(std::string& text, const WireFaults& faults) {
  if (!text.empty() && drawn(faults.truncated)) text.resize(below(text.size()));
  if (text.empty() || !drawn(faults.flipped)) return;
  constexpr std::size_t kMaxBits = 3;  // chosen; as WireFaults says
  for (std::size_t bits = 1 + below(kMaxBits); bits > 0; --bits)
    text[below(text.size())] ^= static_cast<char>(1U << below(8));
}

Nanoseconds FaultyWire::due(const WireFaults& faults, Nanoseconds now) {
  Nanoseconds time = now;
  if (drawn(faults.delayed)) time += from_seconds(faults.delay);
  if (faults.jitter > 0)
    time += from_seconds(std::uniform_real_distribution<double>(0, faults.jitter)(random_));
  if (now >= held_until_ && drawn(faults.held)) held_until_ = now + from_seconds(faults.hold);
  return std::max(time, held_until_);
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
