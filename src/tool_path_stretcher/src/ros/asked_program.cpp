// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "asked_program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "tool_paths/tool_path_files.h"

namespace tool_path_stretcher {

namespace fs = std::filesystem;

namespace {

constexpr const char* kPath = "adapted.csv";
constexpr const char* kReport = "report.json";

/// Turns waypoint_z=into_part into --waypoint-z and into_part.
std::vector<std::string> words_of(const std::vector<std::string>& options) {
  std::vector<std::string> words;
  for (const std::string& option : options) {
    const std::size_t end = option.find('=');
    if (end == std::string::npos || end == 0)
      throw scan_cell_common::UnusableInput("robot_program_options", "'" + option + "'",
                                            "give NAME=VALUE, such as waypoint_z=into_part");
    std::string name = option.substr(0, end);
    std::replace(name.begin(), name.end(), '_', '-');
    words.push_back("--" + name);
    words.push_back(option.substr(end + 1));
  }
  return words;
}

}  // namespace

AskedProgram::AskedProgram(const scan_cell_msgs::StretchToolPathGoal& goal)
    : name_(goal.robot_program) {
  if (!wanted()) return;
  if (fs::path(name_).filename() != fs::path(name_))
    throw scan_cell_common::UnusableInput("robot_program", "'" + name_ + "'",
                                          "give a file's name without a folder");
  std::vector<std::string> words = words_of(goal.robot_program_options);
  std::reverse(words.begin(), words.end());  // in the order CLI11 expects
  CLI::App app;
  options_.add(app);
  try {
    app.parse(words);
  } catch (const CLI::Error& error) {
    throw scan_cell_common::UnusableInput("robot_program_options", error.what(),
                                          "give options of export_path as NAME=VALUE");
  }
  folder_.emplace("stretch");
}

std::optional<FileRecord> AskedProgram::save(const ToolPath& adapted,
                                             const std::string& units) const {
  const std::string file = folder_->file(kPath);
  try {
    tool_paths::save_tool_path(file, adapted);
    FileRecord record = record_of(file, units);
    record.name = kPath;
    return record;
  } catch (const scan_cell_common::Error&) {
    return std::nullopt;  // write() will not find it
  }
}

void AskedProgram::write(scan_cell_msgs::StretchToolPathResult& result) const {
  const fs::path program = folder_->path() / "program" / name_;
  try {
    fs::create_directory(program.parent_path());
    scan_cell_common::save_text(folder_->file(kReport), result.report);
    tool_path_programs::PathToExport to_export;
    to_export.path = folder_->file(kPath);
    to_export.report = folder_->file(kReport);
    to_export.program = program.string();
    result.robot_program_notes = to_export.run(options_);
    for (const auto& entry : fs::directory_iterator(program.parent_path())) {
      scan_cell_msgs::RobotProgramFile file;
      file.name = entry.path().filename().string();
      file.text = scan_cell_common::read_file(entry.path().string());
      result.robot_program.push_back(file);
    }
  } catch (const std::exception& error) {  // also std::filesystem's
    result.robot_program.clear();
    result.robot_program_error = error.what();
  }
  std::sort(result.robot_program.begin(), result.robot_program.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
}

}  // namespace tool_path_stretcher
