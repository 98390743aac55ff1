// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/WorkGoal.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

namespace scan_cell {

/// Options shared by the tools that work a part or preview the work.
struct WorkOptions {
  scan_cell_msgs::WorkGoal goal;
  std::string waypoint_z;
  bool dry_run = false;
  double timeout = 10;  // [s]
};

inline void add_options(CLI::App& app, WorkOptions& options) {
  app.add_option("--path", options.goal.path, "adapted tool path, as adapt wrote it")->required();
  app.add_option("--report", options.goal.report, "report that adapt wrote with it")->required();
  app.add_option("--waypoint-z", options.waypoint_z,
                 "where the z axis of the waypoints points; without: as the cell's parameter says")
      ->check(CLI::IsMember({"into_part", "out_of_part"}));
  app.add_option("--frame", options.goal.frame, "frame of the path; without: world");
  app.add_option("--from-waypoint", options.goal.from_waypoint,
                 "begin with this waypoint, counted from 0");
  app.add_option("--timeout", options.timeout, "seconds to wait for the cell");
}

/// The goal, with absolute paths, since the cell's working directory is another one.
inline scan_cell_msgs::WorkGoal goal_of(const WorkOptions& options) {
  using scan_cell_msgs::WorkGoal;
  WorkGoal goal = options.goal;
  for (std::string* path : {&goal.path, &goal.report, &goal.record})
    if (!path->empty()) *path = std::filesystem::absolute(*path).lexically_normal().string();
  goal.dry_run = static_cast<unsigned char>(options.dry_run);
  if (options.waypoint_z == "into_part") goal.waypoint_z = WorkGoal::Z_INTO_PART;
  if (options.waypoint_z == "out_of_part") goal.waypoint_z = WorkGoal::Z_OUT_OF_PART;
  return goal;
}

}  // namespace scan_cell
