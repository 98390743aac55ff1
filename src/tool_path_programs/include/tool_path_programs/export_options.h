// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scan_cell_common/parameters/parameter_options.h"
#include "tool_path_programs/language.h"
#include "tool_path_programs/path_to_program.h"
#include "tool_paths/path_conventions.h"

namespace tool_path_programs {

/// Options of tools that write programs.
struct ExportOptions {
  std::string language;               //!< empty: by the program's ending
  std::string cell;                   //!< cell file: tool and user frame; empty: by name alone
  std::string tool;                   //!< number or name of the tool on the controller
  std::string user;                   //!< number or name of the user frame on the controller
  std::vector<std::string> comments;  //!< lines at the top
  WriteSettings settings;             //!< of the language
  ExportParameters parameters;        //!< of the way from path to program

  /// Declares them, before the command line is parsed.
  void add(CLI::App& app);

 private:
  friend struct PathToExport;
  scan_cell_common::ParameterOptions typed_;
};

/// A robot that may run a program.
class ProgramRobot {
 public:
  virtual ~ProgramRobot() = default;

  /// Looks whether it can run the program, and sets Move::joints of every move.
  /// @return what the person should know
  /// @throw scan_cell_common::Refused naming the first waypoint that it cannot run
  virtual std::vector<std::string> check(Program& program) const = 0;
};

/// A path in files, and the program that it becomes.
struct PathToExport {
  std::string path;                         //!< adapted: CSV or YAML
  tool_paths::PathConventions conventions;  //!< of the path
  std::string report;                       //!< of stretch; empty: there is none
  std::string program;                      //!< main file; its stem is the program's name

  /// What the program will do.
  /// @param robot checks it; none: nothing does
  /// @param notes gets what the person should know
  /// @throw scan_cell_common::Refused if the report does not accept this path, or the robot cannot
  /// run it
  /// @throw scan_cell_common::Error if the files are of no use
  Program steps(const ExportOptions& options, const ProgramRobot* robot,
                std::vector<std::string>& notes) const;

  /// Reads the path, writes the program and reads it back. Where the path is of no use, or not
  /// accepted, a program of an earlier one is removed; where a file cannot be written, it stays.
  /// @return what the person should know: the files, and notes
  /// @throw scan_cell_common::Refused if the report does not accept this path
  /// @throw scan_cell_common::Error if the files are of no use or the language cannot say it
  /// @param robot checks the program before it is written; none: nothing does
  std::vector<std::string> run(const ExportOptions& options,
                               const ProgramRobot* robot = nullptr) const;

 private:
  WrittenProgram write(const ExportOptions& options, const ProgramRobot* robot) const;
};

}  // namespace tool_path_programs
