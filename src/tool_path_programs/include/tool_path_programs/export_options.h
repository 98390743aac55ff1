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

/// Options of the tools that write programs.
struct ExportOptions {
  std::string language;               //!< empty: from the program's extension
  std::string cell;                   //!< cell file: tool and user frame; empty: by name only
  std::string tool;                   //!< number or name of the tool on the controller
  std::string user;                   //!< number or name of the user frame on the controller
  std::vector<std::string> comments;  //!< lines at the top
  WriteSettings settings;             //!< how the language is written
  ExportParameters parameters;        //!< how the path becomes a program

  /// Declares the options; call it before the command line is parsed.
  void add(CLI::App& app);

 private:
  friend struct PathToExport;
  scan_cell_common::ParameterOptions typed_;
};

/// A robot that may run a program.
class ProgramRobot {
 public:
  virtual ~ProgramRobot() = default;

  /// Checks whether the robot can run the program, and sets Move::joints of every move.
  /// @return notes for the user
  /// @throw scan_cell_common::Refused naming the first waypoint that the robot cannot run
  virtual std::vector<std::string> check(Program& program) const = 0;
};

/// A path file and the program to make from it.
struct PathToExport {
  std::string path;                         //!< adapted path: CSV or YAML
  tool_paths::PathConventions conventions;  //!< of the path
  std::string report;                       //!< report of `stretch`; empty: none
  std::string program;                      //!< main file; its stem is the program's name

  /// Makes the program from the path.
  /// @param robot checks the program; null: no check
  /// @param notes receives notes for the user
  /// @throw scan_cell_common::Refused if the report does not accept this path, or the robot cannot
  /// run it
  /// @throw scan_cell_common::Error if the files are unusable
  Program steps(const ExportOptions& options, const ProgramRobot* robot,
                std::vector<std::string>& notes) const;

  /// Reads the path, writes the program and reads it back. If the path is unusable or not accepted,
  /// an earlier program in that place is removed; if a file cannot be written, the old one stays.
  /// @param robot checks the program before it is written; null: no check
  /// @return notes for the user: the files written, and remarks
  /// @throw scan_cell_common::Refused if the report does not accept this path
  /// @throw scan_cell_common::Error if the files are unusable or the language cannot express the
  /// path
  std::vector<std::string> run(const ExportOptions& options,
                               const ProgramRobot* robot = nullptr) const;

 private:
  WrittenProgram write(const ExportOptions& options, const ProgramRobot* robot) const;
};

}  // namespace tool_path_programs
