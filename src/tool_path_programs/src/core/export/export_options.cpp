// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_programs/export_options.h"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/outputs.h"
#include "scan_cell_common/files/yaml_file.h"
#include "tool_path_programs/accepted_report.h"
#include "tool_path_programs/program_files.h"
#include "tool_path_programs/read_back.h"
#include "tool_paths/tool_path_files.h"

namespace tool_path_programs {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNoether = "noether";

std::string language_names() {
  std::string names;
  for (const Language* language : languages())
    names += language->name() + ", ";
  return names + kNoether;
}

/// The path itself instead of a program, for planners that read noether's files.
WrittenProgram noether_yaml(const tool_paths::ToolPath& path, const std::string& file) {
  WrittenProgram written;
  written.files.push_back({fs::path(file).filename().string(), tool_path_to_noether_yaml(path)});
  const auto again = tool_paths::parse_tool_path_yaml(written.files.front().text, file).path;
  const auto before = positions_of(path);
  const auto after = positions_of(again);
  if (before != after)
    throw scan_cell_common::UnusableInput(file, "it differs when read back",
                                          "please report this with the path");
  written.notes.push_back(std::to_string(before.size()) + " waypoints, read back the same");
  if (!path.process_names.empty())
    written.notes.emplace_back("process values are left out: the format has no place for them");
  return written;
}

const Language& language_for(const ExportOptions& options, const std::string& program) {
  if (!options.language.empty()) return language_named(options.language);
  if (const Language* language = language_of(program)) return *language;
  throw scan_cell_common::InvalidParameter("program " + program, "no language has its extension",
                                           "give --language: " + language_names());
}

Frames frames_of(const ExportOptions& options) {
  Frames frames;
  frames.tool.name = options.tool;
  frames.user.name = options.user;
  if (options.cell.empty()) return frames;
  const auto cell = scan_cell_common::YamlEntry::load(options.cell);
  frames.tool.pose = cell["tool_tip_in_tool0"].pose();
  frames.user.pose = cell["base_link_in_world"].pose().inverse();
  return frames;
}

}  // namespace

void ExportOptions::add(CLI::App& app) {
  app.add_option("--language", language,
                 language_names() + "; default: by the program's extension");
  app.add_option("--dialect", settings.dialect,
                 "controller, for languages with several (docs/robot_programs.md)");
  app.add_option(
      "--max-lines", settings.max_lines,
      "lines of a file or routine; longer programs are split; 0: what the controllers accept");
  app.add_option("--max-speed-change", settings.max_speed_change,
                 "share by which a speed may change when rounded to what the language can express");
  app.add_option("--cell", cell,
                 "cell file: the tool's tip on the flange, and the world as user frame");
  app.add_option("--tool", tool, "number or name of the tool on the controller");
  app.add_option("--user", user, "number or name of the user frame, base or work object");
  app.add_option("--comment", comments, "line at the top of the program, such as the part");
  typed_.add(app, parameters);
}

Program PathToExport::steps(const ExportOptions& options, const ProgramRobot* robot,
                            std::vector<std::string>& notes) const {
  AcceptedReport accepted;
  accepted.comments = {"no report: nothing says that this path was accepted"};
  if (!report.empty()) accepted = accepted_report(report, path);
  ExportParameters parameters = options.parameters;
  options.typed_.read(parameters);
  parameters.name = fs::path(program).stem().string();
  const auto tool_path = tool_paths::load_tool_path(path, conventions);
  Program made = program_of(tool_path, parameters, frames_of(options), accepted.in_air);
  made.comments = options.comments;
  made.comments.insert(made.comments.end(), accepted.comments.begin(), accepted.comments.end());
  if (!tool_path.has_orientation)
    notes.emplace_back("the path has no orientations: the tool points along -z");
  if (robot)
    for (const std::string& found : robot->check(made))
      notes.push_back(found);
  return made;
}

WrittenProgram PathToExport::write(const ExportOptions& options, const ProgramRobot* robot) const {
  if (options.language == kNoether) {
    if (!report.empty()) accepted_report(report, path);
    return noether_yaml(tool_paths::load_tool_path(path, conventions), program);
  }
  const Language& language = language_for(options, program);
  std::vector<std::string> notes;
  const Program meant = steps(options, robot, notes);
  notes.insert(notes.begin(),
               std::to_string(moves_of(meant).size()) + " moves, read back the same");
  WrittenProgram written = write_checked(language, meant, options.settings);
  written.notes.insert(written.notes.begin(), notes.begin(), notes.end());
  return written;
}

std::vector<std::string> PathToExport::run(const ExportOptions& options,
                                           const ProgramRobot* robot) const {
  scan_cell_common::refuse_overwriting(program, {path, report, options.cell});
  WrittenProgram written;
  try {
    written = write(options, robot);
  } catch (const scan_cell_common::Error&) {
    scan_cell_common::remove_old(program);
    throw;
  }
  save_program(program, written.files);
  std::vector<std::string> lines = names_of_saved(program, written.files);
  lines.insert(lines.end(), written.notes.begin(), written.notes.end());
  return lines;
}

}  // namespace tool_path_programs
