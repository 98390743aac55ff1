// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "c4g_driver/durations.h"

namespace c4g_driver {

struct BareRun {
  Durations delays;
  double allocations = 0;  //!< per pose
};

/// Runs in this process, with another one that listens to /tf and joint_states.
class DelayRuns {
 public:
  /// @param program of the bench
  explicit DelayRuns(const std::string& program);

  /// A loop that receives datagrams as long as a state's and publishes the same messages each time.
  BareRun bare(double seconds) const;

  /// The driver's node with the emulated controller in its own process, in a slow motion.
  /// @return time from the kernel's stamp of a datagram until its pose was published
  /// @param priority real-time priority of its receiving thread; 0: normal scheduling
  /// @throw scan_cell_common::Refused if it does not move
  /// @throw scan_cell_common::InvalidParameter if the priority is not allowed here
  Durations driver(double seconds, int priority) const;

 private:
  std::string program_;
};

/// Sends 500 datagrams a second to the first peer that sends one, until this process is ended.
int send_to_whoever_asks(std::uint16_t port);

/// Listens to what the driver publishes.
int listen();

}  // namespace c4g_driver
