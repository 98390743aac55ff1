// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "c4g_driver/tool_check.h"
#include "tool_check/judge/track.h"

namespace c4g_driver {

/// Value and cure of a fault.
using Said = std::pair<std::string, std::string>;

/// Faults along a path: the worst of each kind and joint between two waypoints.
class Findings {
 public:
  /// What a fault is about, and how bad it is.
  struct About {
    ToolFault::Kind kind;
    double severity;        // compared within the kind
    std::string what = "";  // without the place, such as "J5"
    int joint = -1;         // 0 .. 5, if it is about one
  };

  /// Adds the fault, unless a worse one of its kind is on the same way. Places must come in path
  /// order.
  /// @param say returns value and cure, called if the fault is added
  template <class Say>
  void add(const TrackPlace& place, const About& about, const Say& say) {
    if (Fault* fault = place_for(place, about)) {
      std::tie(fault->fault.value, fault->fault.cure) = say();
    }
  }

  /// The faults in path order.
  std::vector<ToolFault> take();

 private:
  struct Fault {
    ToolFault fault;
    double severity;
  };

  Fault* place_for(const TrackPlace& place, const About& about);

  std::vector<Fault> faults_;
};

/// "J5" of joint 4
std::string joint_name(int joint);

/// "waypoint 12", "35 % of the way to waypoint 12"
std::string place_name(std::size_t waypoint, double way);

}  // namespace c4g_driver
