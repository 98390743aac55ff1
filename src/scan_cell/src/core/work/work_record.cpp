// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "work/work_record.h"

#include <nlohmann/json.hpp>

namespace scan_cell {

void WorkRecord::passed(const WorkWaypoint& waypoint, double time) {
  if (waypoint.waypoint)
    passed_.push_back({*waypoint.waypoint, time, waypoint.speed, waypoint.outputs});
}

std::string WorkRecord::text(const SequenceEnd& end, const std::string& path, bool dry) const {
  nlohmann::ordered_json all;
  all["path"] = path;
  all["dry_run"] = dry;
  all["finished"] = end.outcome == Outcome::kFinished;
  all["message"] = end.message;
  all["passed"] = nlohmann::ordered_json::array();
  for (const Passed& each : passed_)
    all["passed"].push_back({{"waypoint", each.waypoint},
                             {"time", each.time},
                             {"speed", each.speed},
                             {"outputs", each.outputs}});
  return all.dump(1) + "\n";
}

}  // namespace scan_cell
