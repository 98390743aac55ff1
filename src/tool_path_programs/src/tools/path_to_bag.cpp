// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <rosbag/bag.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "checked_robot.h"
#include "program_messages.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

using namespace tool_path_programs;

struct Options {
  PathToExport files;
  bool no_report = false;
  std::string frame = "world";
  ExportOptions program;
  RobotOptions robot;
};

void add_options(CLI::App& app, Options& options, scan_cell_common::Outputs& outputs) {
  app.add_option("--path", options.files.path, "adapted tool path: CSV or YAML")->required();
  CLI::Option* const report =
      app.add_option("--report", options.files.report,
                     "report of stretch, which says that this path was accepted");
  app.add_flag("--no-report", options.no_report, "the path has none")->excludes(report);
  outputs.add(app, "--output", options.files.program, "bag")->required();
  app.add_option("--frame", options.frame, "frame of the path's poses")->capture_default_str();
  options.program.add(app);
  options.robot.add(app);
}

/// Saves the whole bag or nothing.
void save(const std::string& file, const nav_msgs::Path& path,
          const trajectory_msgs::JointTrajectory& trajectory) {
  scan_cell_common::save_whole(file, [&](const std::string& name) {
    try {
      rosbag::Bag bag(name, rosbag::bagmode::Write);
      bag.write("tool_path", ros::TIME_MIN, path);
      bag.write("joint_trajectory", ros::TIME_MIN, trajectory);
      bag.close();
      return true;
    } catch (const rosbag::BagException&) {
      return false;
    }
  });
}

int run(Options& options) {
  if (options.files.report.empty() && !options.no_report)
    throw scan_cell_common::InvalidParameter("--report", "not given",
                                             "give the report of the path, or --no-report");
  if (options.robot.urdf.empty())
    throw scan_cell_common::InvalidParameter("--robot", "not given",
                                             "give the URDF of the robot: joints come from it");
  scan_cell_common::check_output(options.files.program, {".bag"}, "write the bag as .bag");
  const CheckedRobot robot(options.robot);
  std::vector<std::string> notes;
  const Program program = options.files.steps(options.program, &robot, notes);
  const auto times = times_of(program, robot.rotational_speed());
  save(options.files.program, path_message(program, options.frame, times),
       trajectory_message(program, robot.joint_names(), times));
  std::printf("%s: %zu poses on tool_path, as many joints on joint_trajectory, %.1f s\n",
              options.files.program.c_str(), times.size(), times.back());
  for (const std::string& note : notes)
    std::printf("%s\n", note.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Writes an adapted tool path into a bag: nav_msgs/Path, and trajectory_msgs/JointTrajectory "
      "of a robot.\n"
      "Exit code 0: written; 2: the path was not accepted, or the robot cannot run it; 1: unusable "
      "input.");
  Options options;
  scan_cell_common::Outputs outputs;
  add_options(app, options, outputs);
  return scan_cell_common::tool_main(
      "path_to_bag", app, argc, argv, [&] { return run(options); }, scan_cell_common::kRefused,
      outputs);
}
