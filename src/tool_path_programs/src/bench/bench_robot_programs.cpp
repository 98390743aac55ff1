// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Times writing and reading back a long path in each language, beside the same path as CSV.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "scan_cell_common/tools/tool_main.h"
#include "tool_path_programs/path_to_program.h"
#include "tool_path_programs/read_back.h"
#include "tool_paths/tool_path_files.h"

namespace {

using namespace tool_path_programs;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A path along a wave; the tool turns along it.
tool_paths::ToolPath long_path(int waypoints) {
  tool_paths::ToolPath path;
  path.name = "long";
  path.has_orientation = true;
  path.segments.push_back({"1", {}});
  for (int i = 0; i < waypoints; ++i) {
    tool_paths::Waypoint waypoint;
    waypoint.pose.translation() << 1e-3 * (i % 1000), 1e-3 * (i / 1000), 0.01 * std::sin(0.01 * i);
    waypoint.pose.rotate(Eigen::AngleAxisd(0.3 * std::sin(0.003 * i), Eigen::Vector3d::UnitX()) *
                         Eigen::AngleAxisd(0.2 * std::cos(0.002 * i), Eigen::Vector3d::UnitY()));
    path.segments.front().waypoints.push_back(waypoint);
  }
  return path;
}

Frames frames() {
  Frames frames;
  frames.tool.pose = Eigen::Isometry3d(Eigen::Translation3d(0, 0, 0.2));
  frames.user.pose = Eigen::Isometry3d(Eigen::Translation3d(0.8, 0, 0));
  return frames;
}

double seconds_as_csv(const tool_paths::ToolPath& path) {
  const Clock::time_point start = Clock::now();
  const std::string text = tool_path_to_csv(path);
  tool_paths::parse_tool_path_csv(text, "path");
  return seconds_since(start);
}

/// G-code knows frames only by number, and joint moves only at the machine's own speed.
Program program_for(const Language& language, const tool_paths::ToolPath& path,
                    ExportParameters parameters) {
  Frames known = frames();
  if (language.name() == "fanuc") known.tool.name = known.user.name = "1";  // known only by number
  if (language.name() != "gcode") return program_of(path, parameters, known);
  parameters.joint_speed = 1;
  return program_of(path, parameters, {{"1", {}}, {"G54", {}}});
}

void run(int waypoints) {
  const tool_paths::ToolPath path = long_path(waypoints);
  const double csv = seconds_as_csv(path);
  std::printf("%d waypoints, written and read back; goal: 5 s for 100000\n%-34s %8s %10s %8s\n",
              waypoints, "", "seconds", "times CSV", "files");
  std::printf("%-34s %8.2f %10.1f %8d\n", "CSV", csv, 1.0, 1);
  ExportParameters parameters;
  parameters.name = "LONG";
  parameters.waypoint_z = WaypointZ::kOutOfPart;
  for (const Language* language : languages()) {
    try {
      const Program program = program_for(*language, path, parameters);
      const Clock::time_point start = Clock::now();
      const WrittenProgram written = write_checked(*language, program, {});
      const double seconds = seconds_since(start);
      std::printf("%-34s %8.2f %10.1f %8zu\n", language->title().c_str(), seconds, seconds / csv,
                  written.files.size());
    } catch (const std::exception& error) {
      std::printf("%-34s cannot express it: %s\n", language->title().c_str(), error.what());
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times programs in robots' languages beside the same path as CSV");
  int waypoints = 100000;
  app.add_option("--waypoints", waypoints)->check(CLI::Range(2, 1000000))->capture_default_str();
  return scan_cell_common::tool_main("bench_robot_programs", app, argc, argv, [&] {
    run(waypoints);
    return 0;
  });
}
