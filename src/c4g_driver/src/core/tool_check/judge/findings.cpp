// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_check/judge/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace c4g_driver {

Findings::Fault* Findings::place_for(const TrackPlace& place, const About& about) {
  auto fault = faults_.rbegin();
  for (; fault != faults_.rend() && fault->fault.waypoint == place.waypoint; ++fault) {
    if (fault->fault.kind != about.kind || fault->fault.about != about.what) continue;
    if (about.severity <= fault->severity) return nullptr;
    break;
  }
  const bool known = fault != faults_.rend() && fault->fault.waypoint == place.waypoint;
  if (!known) faults_.emplace_back();
  Fault& taken = known ? *fault : faults_.back();
  taken.fault.about = about.what;
  taken.severity = about.severity;
  taken.fault.kind = about.kind;
  taken.fault.waypoint = place.waypoint;
  taken.fault.way = place.way;
  taken.fault.tip = place.tip;
  if (about.joint >= 0) taken.fault.joint = about.joint;
  taken.fault.thing =
      place_name(place.waypoint, place.way) + (about.what.empty() ? "" : ", " + about.what);
  return &taken;
}

std::vector<ToolFault> Findings::take() {
  std::vector<ToolFault> faults;
  faults.reserve(faults_.size());
  for (Fault& fault : faults_)
    faults.push_back(std::move(fault.fault));
  const auto order = [](const ToolFault& fault) {
    return std::tuple(fault.waypoint, fault.way, fault.kind);
  };
  std::stable_sort(faults.begin(), faults.end(),
                   [&](const ToolFault& a, const ToolFault& b) { return order(a) < order(b); });
  return faults;
}

std::string joint_name(int joint) {
  return fmt::format("J{}", joint + 1);
}

std::string place_name(std::size_t waypoint, double way) {
  if (way >= 1) return fmt::format("waypoint {}", waypoint);
  return fmt::format("{} % of the way to waypoint {}", std::lround(100 * way), waypoint);
}

}  // namespace c4g_driver
