// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>

#include "controller/motion/speed_profile.h"
#include "scan_cell_common/pose/timed_pose.h"
#include "scan_cell_sim/controller/path.h"

namespace scan_cell_sim {

/// A path run at a speed from an instant on.
struct Run {
  scan_cell_common::Nanoseconds start = 0;  //!< host time
  std::shared_ptr<const Path> path;
  SpeedProfile profile;
  bool follows = false;  // its outputs are on: it does not brake to a stop

  double way(scan_cell_common::Nanoseconds host) const;
  double speed(scan_cell_common::Nanoseconds host) const;  //!< [1/s]
  bool over(scan_cell_common::Nanoseconds host) const;
  std::uint32_t outputs(scan_cell_common::Nanoseconds host) const;
};

/// The robot's present and past motion, without gaps: each run lasts until the next begins. Safe
/// for use from several threads.
class MotionLog {
 public:
  /// Before the first run, the robot stood at `start`.
  explicit MotionLog(const Joints& start);

  /// Runs must begin in the order of time.
  void begin(const Run& run);

  /// The run at an instant. Earlier instants than the oldest run get its start.
  Run at(scan_cell_common::Nanoseconds host) const;

  Run latest() const;

 private:
  mutable std::mutex mutex_;
  std::deque<Run> runs_;
};

}  // namespace scan_cell_sim
