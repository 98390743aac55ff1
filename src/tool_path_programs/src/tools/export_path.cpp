// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/outputs.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tool_path_programs/accepted_report.h"
#include "tool_path_programs/path_to_program.h"
#include "tool_path_programs/program_files.h"
#include "tool_path_programs/read_back.h"
#include "tool_paths/path_options.h"
#include "tool_paths/tool_path_files.h"

namespace {

using namespace tool_path_programs;
namespace fs = std::filesystem;

struct Options {
  std::string path;
  std::string report;
  bool no_report = false;
  std::string output;
  std::string language;
  std::string cell;
  std::string tool;
  std::string user;
  std::string units;
  std::vector<std::string> comments;
  tool_paths::PathOptions conventions;
  scan_cell_common::ParameterOptions typed;
  ExportParameters parameters;
  WriteSettings settings;
};

std::string language_names() {
  std::string names;
  for (const Language* language : languages())
    names += (names.empty() ? "" : ", ") + language->name();
  return names;
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("--path", options.path, "adapted tool path: CSV or YAML")->required();
  CLI::Option* const report = app.add_option(
      "--report", options.report, "report of stretch, which says that this path was accepted");
  app.add_flag("--no-report", options.no_report, "the path has none: nobody says it was accepted")
      ->excludes(report);
  app.add_option("--output", options.output,
                 "program; its name without the ending is the program's. Further files of the "
                 "program come beside it")
      ->required();
  app.add_option("--language", options.language,
                 language_names() + "; without it the output's ending tells");
  app.add_option("--dialect", options.settings.dialect,
                 "controller, of languages with several (docs/robot_programs.md)");
  app.add_option("--max-lines", options.settings.max_lines,
                 "of a file or routine, longer programs are split; 0: what the controllers take");
  app.add_option("--max-speed-change", options.settings.max_speed_change,
                 "share by which a speed may be rounded to what the language can say");
  app.add_option("--cell", options.cell,
                 "cell file: the tool's tip on the flange, and the world as user frame");
  app.add_option("--tool", options.tool, "number or name of the tool on the controller");
  app.add_option("--user", options.user, "number or name of the user frame, base or work object");
  app.add_option("--comment", options.comments, "line at the top of the program, such as the part");
  app.add_option("--units", options.units, "of lengths in the path: m, mm or inch");
  add_path_options(app, options.conventions);
  options.typed.add(app, options.parameters);
}

const Language& language_for(const Options& options) {
  if (!options.language.empty()) return language_named(options.language);
  if (const Language* language = language_of(options.output)) return *language;
  throw scan_cell_common::InvalidParameter("--output", options.output,
                                           "give --language: " + language_names());
}

Frames frames_of(const Options& options) {
  Frames frames;
  frames.tool.name = options.tool;
  frames.user.name = options.user;
  if (options.cell.empty()) return frames;
  const auto cell = scan_cell_common::YamlEntry::load(options.cell);
  frames.tool.pose = cell["tool_tip_in_tool0"].pose();
  frames.user.pose = cell["base_link_in_world"].pose().inverse();
  return frames;
}

AcceptedReport report_of(const Options& options) {
  if (!options.report.empty()) return accepted_report(options.report, options.path);
  if (!options.no_report)
    throw scan_cell_common::InvalidParameter(
        "--report", "not given", "give the report of the path, or --no-report if there is none");
  return {{"no report: nothing says that this path was accepted"}, {}};
}

WrittenProgram write(Options& options) {
  scan_cell_common::refuse_overwriting(options.output,
                                       {options.path, options.report, options.cell});
  options.typed.read(options.parameters);
  const Language& language = language_for(options);
  const AcceptedReport report = report_of(options);
  options.parameters.name = fs::path(options.output).stem().string();
  const auto path =
      tool_paths::load_tool_path(options.path, options.conventions.typed(options.units));
  Program program = program_of(path, options.parameters, frames_of(options), report.in_air);
  program.comments = options.comments;
  program.comments.insert(program.comments.end(), report.comments.begin(), report.comments.end());
  WrittenProgram written = write_checked(language, program, options.settings);
  std::printf("%s: %zu moves, read back the same\n", language.title().c_str(),
              moves_of(program).size());
  if (!path.has_orientation)
    written.notes.emplace_back(
        "the path has no orientations: the tool points along -z of its frame");
  return written;
}

void save(const Options& options, const WrittenProgram& written) {
  save_program(options.output, written.files);
  for (const std::string& name : names_of_saved(options.output, written.files))
    std::printf("%s\n", name.c_str());
  for (const std::string& note : written.notes)
    std::printf("note: %s\n", note.c_str());
}

int run(Options& options) {
  WrittenProgram written;
  try {
    written = write(options);
  } catch (const scan_cell_common::FileError&) {
    throw;
  } catch (const scan_cell_common::Error&) {
    // a program of an earlier path must not be taken for this one's
    scan_cell_common::remove_old(options.output);
    throw;
  }
  save(options, written);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Writes an adapted tool path as a program in a robot's language, and reads it back.\n"
      "Exit code 0: written; 2: the path was not accepted; 1: unusable input, or the language "
      "cannot say it.");
  Options options;
  add_options(app, options);
  return scan_cell_common::tool_main(
      "export_path", app, argc, argv, [&] { return run(options); }, scan_cell_common::kRefused);
}
