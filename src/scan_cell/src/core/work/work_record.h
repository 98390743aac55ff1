// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sequence/sequence_end.h"
#include "work/work_plan.h"

namespace scan_cell {

/// What was done: each waypoint of the path that was passed, and when that was heard.
class WorkRecord {
 public:
  /// @param time [s] since 1970
  void passed(const WorkWaypoint& waypoint, double time);

  /// Of the path, without approach and retract.
  std::size_t waypoints() const { return passed_.size(); }

  /// As JSON, in SI units.
  std::string text(const SequenceEnd& end, const std::string& path, bool dry) const;

 private:
  struct Passed {
    std::size_t waypoint;
    double time;
    double speed;
    std::uint32_t outputs;
  };
  std::vector<Passed> passed_;
};

}  // namespace scan_cell
