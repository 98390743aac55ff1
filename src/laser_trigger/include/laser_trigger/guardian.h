// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "laser_trigger/trigger_port.h"
#include "scan_cell_common/net/descriptor.h"

namespace laser_trigger {

/// A small separate process that sets all lines low when this process ends for any reason: it
/// blocks on a socket pair whose other end the kernel then closes. It has its own session and
/// ignores terminal signals. It opens the port itself, since an inherited port would keep this
/// process' claim alive after its death.
///
/// While armed, this process must call alive(). If it hangs or is stopped for longer than the
/// timeout, the guardian kills it, which frees the claim, and then sets the lines low.
class Guardian {
 public:
  /// Forks: create it first in main(), while the process has only one thread.
  /// @throw scan_cell_common::ConnectionError if no process can be created
  Guardian();

  /// Starts guarding a port. The guardian opens it once, so that errors show now rather than later.
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
