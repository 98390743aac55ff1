// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "laser_trigger/trigger_port.h"
#include "scan_cell_common/net/descriptor.h"

namespace laser_trigger {

/// A small process of its own that sets all lines low when this process ends, in whatever way: it
/// blocks on a socket pair whose other end the kernel closes. It has its own session and ignores
/// the signals of a terminal, and opens the port by itself, since a port inherited from this
/// process would keep this process' claim alive beyond its death.
///
/// While armed() this process must call alive(); if it hangs (or is stopped) for longer than the
/// timeout the guardian kills it, which frees the claim, and then sets the lines low.
class Guardian {
 public:
  /// Forks: make it first thing in main(), while there is only one thread.
  /// @throw scan_cell_common::ConnectionError if there is no process to be had
  Guardian();

  /// Tells it what to watch over. It opens the port once, so that what would fail later fails now.
  /// @param hang_timeout [s] without alive() while armed, after which this process is killed
  /// @throw scan_cell_common::ConnectionError if the guardian is gone or cannot open the port
  void watch(const PortAddress& address, double hang_timeout);

  /// @throw scan_cell_common::ConnectionError if the guardian is gone: nothing may be armed then
  void alive(bool armed);

  int process() const { return process_; }  //!< id of the guardian's process

 private:
  void send(const void* message, std::size_t size) const;

  scan_cell_common::Descriptor socket_;
  int process_ = -1;
};

}  // namespace laser_trigger
