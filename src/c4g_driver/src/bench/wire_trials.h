// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "c4g_driver/client.h"
#include "scan_cell_sim/controller/controller.h"

/// Trials of the client against the emulated controller over a bad network with real sockets,
/// compared with what the controller really did. For tests and benchmarks.
namespace c4g_driver {

/// In both directions: 30 % lost, 30 % repeated, 30 % overtaken.
scan_cell_sim::ControllerFaults bad_wire();

/// Poses delivered from a position stream.
struct StreamTrial {
  std::uint64_t handed_on = 0;
  std::uint64_t wrong = 0;      //!< not where the flange was at that controller time
  std::uint64_t repeated = 0;   //!< of an instant already delivered
  std::uint64_t stale = 0;      //!< of an instant before one already delivered
  std::uint64_t backward = 0;   //!< stamped no later than the one before
  std::vector<double> late_by;  //!< [s] stamp minus true instant, ascending
  LinkReport link;
  double duration = 0;  //!< [s]
  int motions = 0;
};

/// @param period [s] of the stream
/// @throw scan_cell_common::Error if the client does not connect
StreamTrial run_stream_trial(const std::shared_ptr<const RobotModel>& robot, double period,
                             double seconds, const scan_cell_sim::ControllerFaults& faults);

/// Outcomes of commands, by the client's answers and by what the controller did.
struct CommandTrial {
  std::uint64_t done = 0;            //!< reported as done, and done once
  std::uint64_t refused = 0;         //!< with a reason, and not done
  std::uint64_t unanswered = 0;      //!< link lost meanwhile, with a reason; done once or never
  std::uint64_t done_twice = 0;      //!< or more
  std::uint64_t lost = 0;            //!< reported as done, and not done
  std::uint64_t done_in_secret = 0;  //!< reported as refused, and done
  double duration = 0;               //!< [s]
};

/// @param commands up to 10000
/// @throw scan_cell_common::Error if the client does not connect, or a motion does not arrive
CommandTrial run_command_trial(const std::shared_ptr<const RobotModel>& robot, int commands,
                               const scan_cell_sim::ControllerFaults& faults);

}  // namespace c4g_driver
