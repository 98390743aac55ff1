// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "scan_cell_common/clock/durations.h"

namespace c4g_driver {

struct BareRun {
  scan_cell_common::Durations delays;
  double allocations = 0;  //!< per pose
};

/// Runs in this process, while another one listens to /tf and joint_states.
class DelayRuns {
 public:
  /// @param program of the bench
  explicit DelayRuns(const std::string& program);

  /// A loop that receives datagrams of the same length as a state and publishes the same messages.
  BareRun bare(double seconds) const;

  /// The driver's node during a slow motion, with the emulated controller in its own process.
  /// @return times from the kernel's stamp of a datagram to the publication of its pose
  /// @param priority real-time priority of the receiving thread; 0: normal scheduling
  /// @throw scan_cell_common::Refused if the robot does not move
  /// @throw scan_cell_common::InvalidParameter if the priority is not permitted here
  scan_cell_common::Durations driver(double seconds, int priority) const;

 private:
  std::string program_;
};

/// Sends 500 datagrams a second to the first peer that sends one, until this process ends.
int send_to_whoever_asks(std::uint16_t port);

/// Listens to what the driver publishes.
int listen();

}  // namespace c4g_driver
