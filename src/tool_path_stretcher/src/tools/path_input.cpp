// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_input.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/pose/unit_quaternion.h"
#include "tool_path_programs/adapted_program.h"
#include "tool_path_programs/program_files.h"
#include "tool_paths/tool_path_files.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::InvalidParameter;
using tool_path_programs::Language;

constexpr double kFinestChord = 1e-5;  // [m] if no tolerance is allowed at all; chosen

class PathFile final : public PathInput {
 public:
  PathFile(const std::string& file, const tool_paths::PathConventions& conventions)
      : file_(tool_paths::load_tool_path_file(file, conventions)) {}

  const tool_paths::ToolPath& path() const override { return file_.path; }
  tool_paths::PathContents contents() const override {
    return contents_of(file_.path, file_.layout);
  }
  bool may_be_resampled() const override { return true; }

  std::vector<std::string> save(const std::string& output,
                                const tool_paths::ToolPath& adapted) const override {
    tool_paths::save_tool_path(output, adapted, file_.layout);
    std::vector<std::string> notes;
    // CSV has no place for the other keys of YAML
    if (file_.layout.yaml && scan_cell_common::extension_of(output) == ".csv")
      for (const std::string& key : file_.layout.kept)
        notes.push_back("left out of " + output + ": " + key);
    return notes;
  }

 private:
  tool_paths::ToolPathFile file_;
};

Eigen::Isometry3d pose_from(const std::string& text) {
  std::vector<double> numbers;
  std::stringstream fields(text);
  for (std::string field; std::getline(fields, field, ',');)
    if (const auto number = scan_cell_common::parse_number(field)) numbers.push_back(*number);
  if (numbers.size() != 7)
    throw InvalidParameter("--frame", text, "give NAME=x,y,z,qx,qy,qz,qw in metres");
  Eigen::Isometry3d pose(Eigen::Translation3d(numbers[0], numbers[1], numbers[2]));
  pose.linear() = scan_cell_common::rotation_from<InvalidParameter>(
      {numbers[6], numbers[3], numbers[4], numbers[5]}, "--frame");
  return pose;
}

tool_path_programs::ReadSettings settings_of(const ProgramOptions& options) {
  tool_path_programs::ReadSettings settings;
  settings.dialect = options.dialect;
  settings.calls_without_motion = {options.no_motion.begin(), options.no_motion.end()};
  for (const std::string& frame : options.frames) {
    const std::size_t sign = frame.find('=');
    if (sign == std::string::npos || sign == 0)
      throw InvalidParameter("--frame", frame, "give NAME=x,y,z,qx,qy,qz,qw in metres");
    settings.frames[frame.substr(0, sign)] = pose_from(frame.substr(sign + 1));
  }
  return settings;
}

class ProgramFile final : public PathInput {
 public:
  ProgramFile(const Language& language, const std::string& file, const ProgramOptions& options)
      : language_(language), options_(options), settings_(settings_of(options)), main_(file) {
    text_ =
        language.read(tool_path_programs::load_program(language, file, options.files), settings_);
    tool_path_programs::ProgramPathSettings path;
    path.in_base = options.in_base;
    path.turns_by_via = language.turns_by_via();
    path.arc_chord_error = std::max(options.arc_tolerance, kFinestChord);
    program_path_ = path_of(text_, path);
  }

  const tool_paths::ToolPath& path() const override { return program_path_.path; }

  tool_paths::PathContents contents() const override {
    tool_paths::PathContents contents = contents_of(program_path_.path);
    contents.orientations = "those of a " + language_.title() + " program";
    contents.kept = program_path_.kept;
    return contents;
  }
  bool may_be_resampled() const override { return false; }

  std::vector<std::string> save(const std::string& output,
                                const tool_paths::ToolPath& adapted) const override {
    const auto program = adapted_program(language_, text_, settings_, program_path_, adapted,
                                         options_.arc_tolerance);
    for (const std::string& name : tool_path_programs::names_of_saved(output, program.files))
      scan_cell_common::refuse_overwriting(name, inputs());
    tool_path_programs::save_program(output, program.files);
    std::vector<std::string> notes = program.notes;
    for (const std::string& kept : program_path_.kept)
      notes.push_back("kept: " + kept);
    return notes;
  }

 private:
  std::vector<std::string> inputs() const {
    std::vector<std::string> names = options_.files;
    for (const std::string& name : tool_path_programs::names_of_saved(main_, text_.files))
      names.push_back(name);
    return names;
  }

  const Language& language_;
  const ProgramOptions options_;
  const tool_path_programs::ReadSettings settings_;
  const std::string main_;
  tool_path_programs::ProgramText text_;
  tool_path_programs::ProgramPath program_path_;
};

}  // namespace

void add_program_options(CLI::App& app, ProgramOptions& options) {
  app.add_option("--program-files", options.files, "files that the program of --path calls");
  app.add_option("--no-motion", options.no_motion,
                 "routines that the program calls, and that do not move the robot");
  app.add_option("--frame", options.frames,
                 "pose of a frame that the program names, in the robot's base: "
                 "NAME=x,y,z,qx,qy,qz,qw [m]");
  app.add_option("--dialect", options.dialect, "dialect of the program (docs/robot_programs.md)");
  app.add_flag("--program-in-base", options.in_base,
               "the reference is in the robot's base, not in the program's user frame");
  app.add_option(
         "--arc-tolerance", options.arc_tolerance,
         "largest distance of an arc of the program from the adapted path [m]; an arc farther "
         "off becomes lines")
      ->check(CLI::NonNegativeNumber);
}

std::unique_ptr<PathInput> PathInput::load(const std::string& file, const FileOptions& files,
                                           const ProgramOptions& program) {
  if (const Language* language = tool_path_programs::language_of(file))
    return std::make_unique<ProgramFile>(*language, file, program);
  return std::make_unique<PathFile>(file, files.path_conventions());
}

void PathInput::check_output(const std::string& file, const std::string& output) {
  const Language* language = tool_path_programs::language_of(file);
  if (!language) return tool_paths::check_tool_path_name(output);
  scan_cell_common::check_output(output, {scan_cell_common::extension_of(file)},
                                 "write the program as " + scan_cell_common::extension_of(file));
}

}  // namespace tool_path_stretcher
