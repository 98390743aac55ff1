// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <optional>

#include "checked_robot.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tool_path_programs/export_options.h"
#include "tool_paths/path_options.h"

namespace {

struct Options {
  tool_path_programs::PathToExport files;
  bool no_report = false;
  std::string units;
  tool_paths::PathOptions conventions;
  tool_path_programs::ExportOptions program;
  tool_path_programs::RobotOptions robot;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--path", options.files.path, "adapted tool path: CSV or YAML")->required();
  CLI::Option* const report =
      app.add_option("--report", options.files.report,
                     "report of stretch, which says that this path was accepted");
  app.add_flag("--no-report", options.no_report,
               "the path has no report: nothing says that it was accepted")
      ->excludes(report);
  app.add_option("--output", options.files.program,
                 "file of the program; its name without the extension names the program. Further "
                 "files of the program are written beside it")
      ->required();
  app.add_option("--units", options.units, "units of lengths in the path: m, mm or inch");
  add_path_options(app, options.conventions);
  options.program.add(app);
  options.robot.add(app);
}

int run(Options& options) {
  if (options.files.report.empty() && !options.no_report)
    throw scan_cell_common::InvalidParameter(
        "--report", "not given", "give the report of the path, or --no-report if there is none");
  options.files.conventions = options.conventions.typed(options.units);
  std::optional<tool_path_programs::CheckedRobot> robot;
  if (!options.robot.urdf.empty()) robot.emplace(options.robot);
  for (const std::string& line : options.files.run(options.program, robot ? &*robot : nullptr))
    std::printf("%s\n", line.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Writes an adapted tool path as a program in a robot's language, and reads it back.\n"
      "Exit code 0: written; 2: the path was not accepted, or the robot cannot run it; 1: unusable "
      "input, or the language "
      "cannot say it.");
  Options options;
  add_options(app, options);
  return scan_cell_common::tool_main(
      "export_path", app, argc, argv, [&] { return run(options); }, scan_cell_common::kRefused);
}
