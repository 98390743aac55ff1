// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

namespace scan_cell_sim {

/// What happens to the datagrams of one direction, each by its own draw and in any mix.
struct WireFaults {
  double lost = 0;         //!< probability
  double repeated = 0;     //!< probability; the copy has a fate of its own
  double delayed = 0;      //!< probability; what is delayed is overtaken by what comes after it
  double delay = 0.01;     //!< [s]
  double jitter = 0;       //!< [s] each is later by an evenly drawn time up to this
  double held = 0;         //!< probability that it, and all after it, is held for a while ...
  double hold = 0.05;      //!< [s] ... and they come all at once then
  double flipped = 0;      //!< probability that one to three of its bits change
  double truncated = 0;    //!< probability that its end is missing
  bool link_down = false;  //!< nothing passes
  double silence = 0;      //!< [s] nothing passes for so long after these faults were set
};

/// One number of WireFaults, for those who read them from somewhere.
struct WireFault {
  const char* name;           //!< as parameters call it
  double WireFaults::*value;  //!< the member
  double most;                //!< least is 0
  bool time;                  //!< [s]; else a probability
  const char* effect;         //!< for a person
};

/// Every number of WireFaults.
extern const std::array<WireFault, 10> kWireFaults;

/// @throw scan_cell_common::InvalidParameter naming prefix + name of the first that makes no sense
void check(const WireFaults& faults, const std::string& prefix);

}  // namespace scan_cell_sim
