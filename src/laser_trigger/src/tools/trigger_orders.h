// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "laser_trigger/pulse_generator.h"

/// The orders of the program trigger; a signal ends each of them early.
namespace laser_trigger {

/// The longest on-time of any order.
constexpr double kLongestOn = 300;  //!< [s] as the node's longest_on

struct Order {
  double rate = 0;           //!< [Hz] 0: no pulses
  std::uint8_t lasers = 0;   //!< mask, bit 0: laser_0
  std::uint64_t pulses = 0;  //!< number after which the order ends; 0: after `seconds`
  double seconds = 0;        //!< [s]
  bool alternate = false;    //!< the lasers take turns, pulse by pulse
};

/// Switches on, waits for the end, and prints what was done. A guardian process sets the lines low
/// if this process dies.
/// @throw scan_cell_common::Refused if the order is invalid, or a signal ended it early
/// @throw scan_cell_common::ConnectionError if port or guardian cannot be reached, or were lost
void carry_out(const Order& order, const PortAddress& address);

/// Prints what the lines do, as the circuit at the other end of a loopback port.
/// @param seconds how long; 0: until a signal arrives
/// @throw scan_cell_common::Refused for a parallel port, which cannot be watched
/// @throw scan_cell_common::ConnectionError if another program already is the circuit
void watch(const PortAddress& address, double seconds);

}  // namespace laser_trigger
