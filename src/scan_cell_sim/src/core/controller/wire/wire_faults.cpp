// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/controller/wire_faults.h"

#include <fmt/format.h>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_sim {

const std::array<WireFault, 10> kWireFaults = {
    {{"lost", &WireFaults::lost, 1, false, "is lost"},
     {"repeated", &WireFaults::repeated, 1, false, "comes twice"},
     {"delayed", &WireFaults::delayed, 1, false, "comes later than others sent after it"},
     {"delay", &WireFaults::delay, 10, true, "delay of a delayed datagram"},
     {"jitter", &WireFaults::jitter, 10, true, "longest random delay of each datagram"},
     {"held", &WireFaults::held, 1, false, "begins a burst: it and all after it come at once"},
     {"hold", &WireFaults::hold, 10, true, "how long a burst is held back"},
     {"flipped", &WireFaults::flipped, 1, false, "has one to three bits flipped"},
     {"truncated", &WireFaults::truncated, 1, false, "is truncated"},
     {"silence", &WireFaults::silence, 3600, true, "nothing passes for this long, from now on"}}};

void check(const WireFaults& faults, const std::string& prefix) {
  for (const WireFault& fault : kWireFaults) {
    const double value = faults.*fault.value;
    if (value >= 0 && value <= fault.most) continue;  // not so for NaN
    const std::string unit = fault.time ? " s" : "";
    throw scan_cell_common::InvalidParameter(
        prefix + fault.name, fmt::format("{:g}{}", value, unit),
        fmt::format("give 0 .. {}{}", static_cast<int>(fault.most), unit));
  }
}

}  // namespace scan_cell_sim
