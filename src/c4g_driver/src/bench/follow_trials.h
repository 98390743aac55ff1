// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "c4g_driver/client.h"
#include "scan_cell_sim/controller/controller.h"

namespace c4g_driver {

/// Outcomes of tool paths, by the client's answers and by what the controller did.
struct FollowTrial {
  std::uint64_t followed = 0;        //!< to the end, each waypoint once, in order
  std::uint64_t refused = 0;         //!< with a reason; nothing moved
  std::uint64_t ended_early = 0;     //!< with a reason; each waypoint up to there once, in order
  std::uint64_t twice = 0;           //!< begun by the controller more than once
  std::uint64_t out_of_order = 0;    //!< a waypoint was left out, repeated or too early
  std::uint64_t in_secret = 0;       //!< refused, but begun; followed, but not; or outputs left on
  std::vector<std::string> reasons;  //!< of the paths that were refused or ended early
  std::vector<std::string> faults;   //!< what happened in twice, out_of_order and in_secret
  std::uint64_t waypoints = 0;       //!< of all paths followed to the end
  double duration = 0;               //!< [s]
};

/// Follows one path after the other, each from the end of the one before.
/// @throw scan_cell_common::Error if the client does not connect
FollowTrial run_follow_trial(const std::shared_ptr<const RobotModel>& robot, int paths,
                             const scan_cell_sim::ControllerFaults& faults);

}  // namespace c4g_driver
