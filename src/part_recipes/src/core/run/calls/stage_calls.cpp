// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/calls/stage_calls.h"

#include <fmt/format.h>

#include <filesystem>

#include "recipe/places_file.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

std::string adapted_path(const Recipe& recipe) {
  return "../" + path_name(recipe);
}

}  // namespace

std::string path_name(const Recipe& recipe) {
  return "adapted_path" + fs::path(recipe.path.file).extension().string();
}

ToolCall scan_call(const Recipe& recipe, const Hashes& calibration, bool bag, double timeout) {
  ToolCall call{"scan",
                "scan_cell",
                {"scan", "--program", recipe.program, "--output", "scan.ply", "--report",
                 "../scan.json", "--timeout", fmt::format("{}", timeout)}};
  for (const auto& [name, hash] : calibration)
    call.command.insert(call.command.end(), {"--calibrated-with", name, hash});
  if (bag) call.command.insert(call.command.end(), {"--bag", "../scan.bag"});
  return call;
}

ToolCall clean_call(const Recipe& recipe, const std::string& scan, const std::string& units) {
  ToolCall call{"clean",
                "cloud_preprocess",
                {"clean_cloud", "--input", scan, "--output", "../object.ply", "--units", units,
                 "--output-units", "m"}};
  if (!recipe.cleaning.empty())
    call.command.insert(call.command.end(), {"--config", recipe.cleaning});
  return call;
}

ToolCall stretch_call(const Recipe& recipe, const std::string& into) {
  ToolCall call{"stretch",
                "tool_path_stretcher",
                {"stretch", "--reference", recipe.reference.file, "--reference-units",
                 recipe.reference.units, "--object", "../object.ply", "--object-units", "m",
                 "--path", recipe.path.file, "--path-units", recipe.path.units, "--output",
                 into + "/" + path_name(recipe), "--report", into + "/report.json"}};
  add_options(call, recipe.path.options);
  add_options(call, recipe.stretch);
  return call;
}

ToolCall edit_call(const Recipe& recipe) {
  const std::string unedited = std::string("../") + kUnedited + "/";
  ToolCall call{"edit",
                "part_recipes",
                {"edit_path", "--path", unedited + path_name(recipe), "--units", recipe.path.units,
                 "--edits", kPathEdits, "--report", unedited + "report.json", "--output",
                 adapted_path(recipe), "--output-report", "../report.json"}};
  add_options(call, recipe.path.options);
  return call;
}

ToolCall sight_call(const Recipe& recipe, const std::vector<std::string>& region,
                    const std::string& report) {
  ToolCall call{
      "sight",
      "pass_planner",
      {"seen_waypoints", "--reference", recipe.reference.file, "--units", recipe.reference.units,
       "--path", recipe.path.file, "--path-units", recipe.path.units, "--report", report,
       "--program", recipe.program, "--scanner", kScannerModel, "--output", "../sight.json"}};
  call.command.insert(call.command.end(), region.begin(), region.end());
  return call;
}

ToolCall recheck_call(const Recipe& recipe, const fs::path& run) {
  // A path moved by a person may be off the surface.
  const fs::path unedited = run / kUnedited;
  const fs::path path = (fs::exists(unedited) ? unedited : run) / path_name(recipe);
  ToolCall call{
      "stretch",
      "tool_path_stretcher",
      {"stretch", "--reference", (run / "object.ply").string(), "--reference-units", "m",
       "--object", "../object.ply", "--object-units", "m", "--path", path.string(), "--path-units",
       recipe.path.units, "--output", adapted_path(recipe), "--report", "../report.json"}};
  add_options(call, recipe.path.options);
  add_options(call, recipe.stretch);
  return call;
}

ToolCall deviations_call(const Recipe& recipe) {
  return {"deviations",
          "part_recipes",
          {"deviations", "--reference", recipe.reference.file, "--reference-units",
           recipe.reference.units, "--object", "../object.ply", "--report", "../report.json",
           "--tolerance", fmt::format("{}", recipe.tolerance), "--places", kPlacesFile, "--output",
           "../deviation.ply", "--summary", "../deviation.json"}};
}

std::string program_file(const RobotProgram& program) {
  return (fs::path("..") / "programs" / program.file).string();
}

ToolCall export_call(const Recipe& recipe, const RobotProgram& program) {
  ToolCall call{"export_" + fs::path(program.file).filename().string(),
                "tool_path_programs",
                {"export_path", "--path", adapted_path(recipe), "--units", recipe.path.units,
                 "--report", "../report.json", "--output", program_file(program)}};
  add_options(call, recipe.path.options);
  add_options(call, program.options);
  return call;
}

namespace {

/// @param tool work or preview_work
ToolCall call_of_work(const Recipe& recipe, const fs::path& run, bool dry, const std::string& tool,
                      double timeout) {
  ToolCall call{dry ? "dry_run" : "work",
                "scan_cell",
                {tool, "--path", (run / path_name(recipe)).string(), "--report",
                 (run / "report.json").string(), "--timeout", fmt::format("{}", timeout)}};
  if (dry) call.command.emplace_back("--dry-run");
  add_options(call, recipe.work);
  return call;
}

}  // namespace

ToolCall work_call(const Recipe& recipe, const fs::path& run, bool dry, const fs::path& record,
                   double timeout) {
  ToolCall call = call_of_work(recipe, run, dry, "work", timeout);
  call.command.insert(call.command.end(), {"--record", record.string()});
  return call;
}

ToolCall preview_call(const Recipe& recipe, const fs::path& run, bool dry, double timeout) {
  return call_of_work(recipe, run, dry, "preview_work", timeout);
}

}  // namespace part_recipes
