// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <set>

#include "deviation/scene/path_reading.h"
#include "path_edits/edited_report.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/sha256.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tool_path_programs/accepted_report.h"
#include "tool_path_programs/program_files.h"
#include "tool_paths/path_edits.h"
#include "tool_paths/tool_path_files.h"

namespace {

using namespace part_recipes;

struct Options {
  std::string path;
  PathReadingOptions reading;
  std::string edits;
  std::string report;  // empty: the path has none
  std::string output;
  std::string output_report;
};

void add_options(CLI::App& app, Options& options, scan_cell_common::Outputs& outputs) {
  app.add_option("--path", options.path, "tool path: CSV or YAML")->required();
  app.add_option("--units", options.reading.units,
                 "units of the path: m, mm or inch; default: as its names say, else metres");
  add_reading_options(app, options.reading);
  app.add_option("--edits", options.edits, "list of edits: YAML (docs/editing_a_path.md)")
      ->required();
  CLI::Option* const report =
      app.add_option("--report", options.report, "report of stretch, which accepted the path");
  outputs.add(app, "--output", options.output, "edited path, in the format of the path's file")
      ->required();
  outputs.add(app, "--output-report", options.output_report, "report of the edited path")
      ->needs(report);
}

/// A new process value must not have a name that is already used in the file.
void check_names(const tool_paths::ToolPath& before, const tool_paths::ToolPath& after,
                 const tool_paths::PathLayout& layout) {
  std::set<std::string> taken(layout.pose.position.begin(), layout.pose.position.end());
  taken.insert(layout.pose.names.begin(), layout.pose.names.end());
  taken.insert(layout.columns.begin(), layout.columns.end());
  taken.insert(layout.kept.begin(), layout.kept.end());
  taken.insert({"segment", "name", "poses", "position", "orientation"});
  for (const std::string& name : before.process_names)
    taken.erase(name);
  for (const std::string& name : after.process_names)
    if (taken.count(name) > 0)
      throw scan_cell_common::UnusableInput("process value '" + name + "'",
                                            "the path's file has something else of this name",
                                            "give it another name");
}

/// The saved path must read back as meant: a name may also mean an orientation.
void check_saved(const Options& options, const tool_paths::ToolPath& path) {
  const tool_paths::ToolPath back = load_path(options.output, options.reading.typed()).path;
  bool same =
      back.process_names == path.process_names && back.segments.size() == path.segments.size();
  for (std::size_t i = 0; same && i < path.segments.size(); ++i)
    same = back.segments[i].waypoints.size() == path.segments[i].waypoints.size();
  if (!same)
    throw scan_cell_common::UnusableInput(options.output, "does not read back as meant",
                                          "check the names of the process values");
}

int run(const Options& options) {
  if (tool_path_programs::language_of(options.path) != nullptr)
    throw scan_cell_common::UnusableInput(options.path, "a robot's program",
                                          "edit it on the robot, or give CSV or YAML");
  tool_paths::check_tool_path_name(options.output);
  if (!options.report.empty() && options.output_report.empty())
    throw scan_cell_common::InvalidParameter("--output-report", "not given",
                                             "say where the report of the edited path goes");
  if (!options.report.empty())
    tool_path_programs::accepted_report(options.report, options.path);  // or it is refused
  const auto file = load_path(options.path, options.reading.typed());
  const auto edits = tool_paths::load_path_edits(options.edits);
  const auto edited = tool_paths::edited(file.path, edits);
  const tool_paths::ToolPath result = marked(edited);
  check_names(file.path, result, file.layout);
  tool_paths::save_tool_path(options.output, result, layout_for(result, file.layout));
  try {
    check_saved(options, result);
  } catch (const scan_cell_common::Error&) {
    std::filesystem::remove(options.output);
    throw;
  }
  if (!options.report.empty()) {
    const auto output =
        tool_path_stretcher::record_of(options.output, contents_of(result, file.layout).units);
    scan_cell_common::save_text(
        options.output_report,
        edited_report({scan_cell_common::read_file(options.report), options.report}, edited,
                      {edits, scan_cell_common::sha256_of_file(options.edits)}, output));
  }
  for (const std::string& key : file.layout.kept)
    std::cout << "left out of " << options.output << ": " << key << '\n';
  for (const tool_paths::PathEdit& edit : edits)
    std::cout << to_string(edit) << '\n';
  std::cout << options.output << ": " << edited.origins.size() << " waypoints\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Moves, turns, deletes and adds waypoints of a tool path by a list of edits. What was edited "
      "is marked.\nExit code 0: the edited path was written; 2: refused; 1: unusable input.");
  scan_cell_common::Outputs outputs;
  Options options;
  add_options(app, options, outputs);
  return scan_cell_common::tool_main(
      "edit_path", app, argc, argv, [&] { return run(options); }, scan_cell_common::kRefused,
      outputs);
}
