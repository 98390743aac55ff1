// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sequence/sequence_end.h"
#include "work/work_plan.h"

namespace scan_cell {

/// Record of the work: each waypoint passed, and when that was reported.
class WorkRecord {
 public:
  /// @param time [s] since 1970
  void passed(const WorkWaypoint& waypoint, double time);

  /// Number of waypoints of the path passed, without approach and retract.
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
