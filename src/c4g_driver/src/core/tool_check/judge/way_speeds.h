// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "tool_check/judge/findings.h"
#include "tool_check/judge/judge.h"
#include "tool_check/judge/tool_line.h"

namespace c4g_driver {

/// Checks the speeds of tip, flange and joints between waypoints, one place after the other.
class WaySpeeds {
 public:
  /// @param findings receives the faults; both must outlive this object
  WaySpeeds(const ToolCheckSubject& subject, Findings& findings)
      : subject_(subject), findings_(findings) {}

  /// Begins the way to a waypoint, before its places.
  void enter(const TrackPlace& place, const ToolLine& line);

  /// Checks a place that is reached in a posture that is not singular.
  void look(const TrackPlace& place);

  const std::optional<SlowestPlace>& slowest() const { return slowest_; }  // so far

 private:
  void check_tool(const TrackPlace& place, const std::string& name, double rate);
  Said too_fast(double rate, int joint, double most) const;
  void take_slowest(const TrackPlace& place, double joint_seconds, int joint);

  const ToolCheckSubject& subject_;
  Findings& findings_;
  std::optional<SlowestPlace> slowest_;
  double length_ = 0;        // [m] of the way to the waypoint
  double turn_seconds_ = 0;  // of the tool
  double wanted_ = 0;        // [m/s]
  double seconds_ = 0;       // [s] of the way at the path's speed
};

}  // namespace c4g_driver
