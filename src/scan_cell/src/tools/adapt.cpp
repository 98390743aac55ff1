// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "client/adaptation.h"
#include "scan_cell/progress_bar.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/outputs.h"
#include "scan_cell_common/ros/node_main.h"
#include "tool_path_programs/export_options.h"

namespace {

struct Options {
  std::string program;
  scan_cell::AdaptationFiles files;
  double timeout = 60;
  std::string robot_program;  // empty: none
  tool_path_programs::ExportOptions exported;
};

/// Writes the adapted path as a robot program.
void write_program(const Options& options) {
  const std::filesystem::path folder(options.files.output);
  tool_path_programs::PathToExport files;
  files.path = (folder / "adapted_path.csv").string();
  files.report = (folder / "report.json").string();
  files.program = options.robot_program;
  for (const std::string& line : files.run(options.exported))
    std::printf("%s\n", line.c_str());
}

/// @return the process's exit code
int adapt(const Options& options) {
  scan_cell::clear_results(options.files);
  if (!options.robot_program.empty()) scan_cell_common::remove_old(options.robot_program);
  const auto program = scan_cell::load_scan_program(options.program);
  scan_cell::CellClient client(ros::NodeHandle(), {});
  scan_cell_msgs::ScanResult scan;
  scan_cell::ProgressBar bar("adapt");
  const auto object = client.scan_clean(
      program, "", options.timeout,
      [&bar](const std::string& what, double share) { bar.show(what, 0.7 * share); }, scan);
  const auto verdict = scan_cell::adapt(
      client, options.files, object, options.timeout,
      [&bar](const std::string& what, double share) { bar.show(what, 0.7 + 0.3 * share); },
      scan.statistics);
  if (verdict.reason == scan_cell_msgs::StretchVerdict::ACCEPTED) {
    if (!options.robot_program.empty()) write_program(options);
    return 0;
  }
  std::fprintf(stderr, "\nadapt: refused: %s: %s\n", verdict.name.c_str(), verdict.message.c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  scan_cell_common::Outputs outputs;
  CLI::App app("Scans the part in the running cell and adapts a tool path to it");
  app.add_option("--program", options.program, "scan program (YAML)")->required();
  app.add_option("--reference", options.files.reference, "clean cloud of the reference part")
      ->required();
  app.add_option("--path", options.files.path, "tool path proven on it (.csv, .yaml)")->required();
  outputs
      .add_folder(app, "--output", options.files.output, "folder for cloud, path and report",
                  scan_cell::result_names())
      ->required();
  app.add_option("--timeout", options.timeout, "seconds to wait for the cell");
  app.add_option("--robot-program", options.robot_program,
                 "the adapted path as a robot's program, too; see export_path");
  options.exported.add(app);
  return scan_cell_common::ros_tool_main(
      "adapt", app, argc, argv, [&] { return adapt(options); }, scan_cell_common::kRefused,
      outputs);
}
