// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "scan_cell/progress_bar.h"
#include "scan_cell/ros/cell_client.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/node_main.h"

namespace {

using scan_cell_msgs::WorkGoal;
using scan_cell_msgs::WorkResult;

struct Options {
  WorkGoal goal;
  std::string waypoint_z;
  bool dry_run = false;
  bool preview = false;
  double timeout = 10;
};

/// The cell's working directory is not this one.
void make_absolute(std::string& path) {
  if (!path.empty()) path = std::filesystem::absolute(path).lexically_normal().string();
}

WorkGoal goal_of(const Options& options) {
  WorkGoal goal = options.goal;
  for (std::string* path : {&goal.path, &goal.report, &goal.record})
    make_absolute(*path);
  goal.dry_run = static_cast<unsigned char>(options.dry_run);
  if (options.waypoint_z == "into_part") goal.waypoint_z = WorkGoal::Z_INTO_PART;
  if (options.waypoint_z == "out_of_part") goal.waypoint_z = WorkGoal::Z_OUT_OF_PART;
  return goal;
}

/// As scan_cell's ~preview_work says it. @return the process's exit code
int preview(const Options& options) {
  scan_cell::CellClient client(ros::NodeHandle(), {});
  const auto answer = client.preview(goal_of(options), options.timeout);
  if (answer.success == 0U) {
    std::fprintf(stderr, "work: %s\n", answer.message.c_str());
    return scan_cell_common::kUnusable;
  }
  const auto& preview = answer.preview;
  for (const scan_cell_msgs::FollowFault& fault : preview.faults)
    std::printf("%s\n", fault.message.c_str());
  std::printf("%zu poses of the tip, %zu faults\n", preview.waypoints.size(),
              preview.faults.size());
  if (std::isfinite(preview.slowest_speed))
    std::printf("slowest on the way to pose %u: %g mm/s at most, as joints and tool can turn\n",
                preview.slowest_waypoint, preview.slowest_speed * 1e3);
  return preview.faults.empty() ? 0 : scan_cell_common::kRefused;
}

/// @return the process's exit code
int work(const Options& options) {
  if (options.preview) return preview(options);
  scan_cell::CellClient client(ros::NodeHandle(), {});
  scan_cell::ProgressBar bar(options.dry_run ? "dry run" : "work");
  const WorkResult result =
      client.work(goal_of(options), options.timeout,
                  [&bar](const std::string& what, double share) { bar.show(what, share); });
  std::printf("%u of %u waypoints passed in %.1f s\n", result.passed, result.waypoints,
              result.seconds);
  std::fflush(stdout);  // before what went wrong
  if (result.outcome == WorkResult::FINISHED) return 0;
  std::fprintf(stderr, "work: %s\n", result.message.c_str());
  return result.outcome == WorkResult::REFUSED ? scan_cell_common::kRefused
                                               : scan_cell_common::kUnusable;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  scan_cell_common::Outputs outputs;
  CLI::App app(
      "Runs an adapted path with the tool in the running cell, or dry: lifted, slow, tool off.\n"
      "Exit code 0: done; 2: refused, nothing moved; 1: it ended early, or could not be looked "
      "at.");
  app.add_option("--path", options.goal.path, "adapted tool path, as adapt wrote it")->required();
  app.add_option("--report", options.goal.report, "report that adapt wrote with it")->required();
  app.add_option(
         "--waypoint-z", options.waypoint_z,
         "where the z axis of the waypoints points; without it as the cell's parameter says")
      ->check(CLI::IsMember({"into_part", "out_of_part"}));
  app.add_option("--frame", options.goal.frame, "of the path; without it world");
  app.add_flag("--dry-run", options.dry_run, "needed once before the first real run of a path");
  app.add_flag("--preview", options.preview,
               "moves nothing: says where the robot cannot follow, and shows the way in rviz");
  app.add_option("--from-waypoint", options.goal.from_waypoint,
                 "begin with this one, counted from 0");
  outputs.add(app, "--record", options.goal.record, "each waypoint that was passed: JSON");
  app.add_option("--timeout", options.timeout, "seconds to wait for the cell");
  return scan_cell_common::ros_tool_main(
      "work", app, argc, argv, [&] { return work(options); }, scan_cell_common::kRefused, outputs);
}
