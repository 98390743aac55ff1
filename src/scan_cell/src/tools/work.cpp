// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <cstdio>

#include "scan_cell/progress_bar.h"
#include "scan_cell/ros/cell_client.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/node_main.h"
#include "work_goal.h"

namespace {

using scan_cell_msgs::WorkResult;

/// @return the process's exit code
int work(const scan_cell::WorkOptions& options) {
  scan_cell::CellClient client(ros::NodeHandle(), {});
  scan_cell::ProgressBar bar(options.dry_run ? "dry run" : "work");
  const WorkResult result =
      client.work(goal_of(options), options.timeout,
                  [&bar](const std::string& what, double share) { bar.show(what, share); });
  std::printf("%u of %u waypoints passed in %.1f s\n", result.passed, result.waypoints,
              result.seconds);
  std::fflush(stdout);  // before the error message
  if (result.outcome == WorkResult::FINISHED) return 0;
  std::fprintf(stderr, "work: %s\n", result.message.c_str());
  return result.outcome == WorkResult::REFUSED ? scan_cell_common::kRefused
                                               : scan_cell_common::kUnusable;
}

}  // namespace

int main(int argc, char** argv) {
  scan_cell::WorkOptions options;
  scan_cell_common::Outputs outputs;
  CLI::App app(
      "Runs an adapted path with the tool in the running cell, or dry: lifted, slow, tool off.\n"
      "Exit code 0: done; 2: refused, nothing moved; 1: it ended early.");
  scan_cell::add_options(app, options);
  app.add_flag("--dry-run", options.dry_run, "needed once before the first real run of a path");
  outputs.add(app, "--record", options.goal.record, "each waypoint that was passed: JSON");
  return scan_cell_common::ros_tool_main(
      "work", app, argc, argv, [&] { return work(options); }, scan_cell_common::kRefused, outputs);
}
