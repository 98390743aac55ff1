// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "scan_cell_common/pose/timed_pose.h"
#include "scan_cell_sim/controller/motion_state.h"

namespace scan_cell_sim {

/// The controller without socket, thread and wire: requests of one client in, answers out, at host
/// times given by the caller. Starts as Controller does. Not safe for use from several threads.
class OfflineController {
 public:
  using Nanoseconds = scan_cell_common::Nanoseconds;  //!< of the host's clock

  OfflineController();
  ~OfflineController();

  /// The answer to a datagram; none if the request is unreadable.
  std::optional<std::string> answer(const std::string& request, Nanoseconds now);

  /// The next datagram of the stream, with the state of this instant; none while the robot stands
  /// still.
  std::optional<std::string> stream(Nanoseconds now);

  MotionState state(Nanoseconds now) const;  //!< true values
  std::uint64_t motions_begun() const;       //!< since its start

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace scan_cell_sim
