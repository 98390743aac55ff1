// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

namespace scan_cell_sim {

/// Faults of the datagrams in one direction, drawn independently and in any combination.
struct WireFaults {
  double lost = 0;         //!< probability
  double repeated = 0;     //!< probability; the copy has its own faults
  double delayed = 0;      //!< probability; later datagrams overtake a delayed one
  double delay = 0.01;     //!< [s]
  double jitter = 0;       //!< [s] each is delayed by a uniform random time up to this
  double held = 0;         //!< probability that it, and all after it, is held for a while ...
  double hold = 0.05;      //!< [s] ... after which they come all at once
  double flipped = 0;      //!< probability that one to three of its bits change
  double truncated = 0;    //!< probability that its end is missing
  bool link_down = false;  //!< nothing passes
  double silence = 0;      //!< [s] nothing passes for this long after the faults were set
};

/// One number of WireFaults, for code that reads them from outside.
struct WireFault {
  const char* name;           //!< as parameters call it
  double WireFaults::*value;  //!< the member
  double most;                //!< least is 0
  bool time;                  //!< [s]; else a probability
  const char* effect;         //!< for a person
};

/// Every number of WireFaults.
extern const std::array<WireFault, 10> kWireFaults;

/// @throw scan_cell_common::InvalidParameter naming prefix + name of the first one out of range
void check(const WireFaults& faults, const std::string& prefix);

}  // namespace scan_cell_sim
