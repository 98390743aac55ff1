// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <cmath>
#include <cstdio>

#include "scan_cell/ros/cell_client.h"
#include "scan_cell_common/ros/node_main.h"
#include "tool_path_programs/place_on_path.h"
#include "work_goal.h"

namespace {

std::string slowest_place(const scan_cell_msgs::WorkPreview& preview) {
  tool_path_programs::PathWaypoints waypoints;
  for (const std::int32_t waypoint : preview.path_waypoints)
    waypoints.push_back(waypoint < 0 ? std::nullopt
                                     : std::optional(static_cast<std::size_t>(waypoint)));
  return tool_path_programs::place_on_path(waypoints, preview.slowest_waypoint, 1);
}

/// Prints the answer of scan_cell's ~preview_work. @return the process's exit code
int preview(const scan_cell::WorkOptions& options) {
  const scan_cell::CellClient client(ros::NodeHandle(), {});
  const auto answer = client.preview(goal_of(options), options.timeout);
  if (answer.success == 0U) {
    std::fprintf(stderr, "preview_work: %s\n", answer.message.c_str());
    return scan_cell_common::kUnusable;
  }
  const scan_cell_msgs::WorkPreview& preview = answer.preview;
  for (const scan_cell_msgs::FollowFault& fault : preview.faults)
    std::printf("%s\n", fault.message.c_str());
  std::printf("%zu poses of the tip, %zu faults\n", preview.waypoints.size(),
              preview.faults.size());
  if (std::isfinite(preview.slowest_speed))
    std::printf("slowest at %s: %g mm/s at most, limited by the turning of joints and tool\n",
                slowest_place(preview).c_str(), preview.slowest_speed * 1e3);
  return preview.faults.empty() ? 0 : scan_cell_common::kRefused;
}

}  // namespace

int main(int argc, char** argv) {
  scan_cell::WorkOptions options;
  CLI::App app(
      "Says where the robot cannot follow an adapted path, and shows the path in rviz. Nothing "
      "moves.\n"
      "Exit code 0: it can follow it; 2: it cannot; 1: not known, for example without a cell.");
  scan_cell::add_options(app, options);
  app.add_flag("--dry-run", options.dry_run, "preview the dry run: lifted and slow");
  return scan_cell_common::ros_tool_main(
      "preview_work", app, argc, argv, [&] { return preview(options); },
      scan_cell_common::kUnusable);
}
