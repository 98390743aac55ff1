// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace part_recipes {

/// The file in a run's folder that makes it a run; it is written last.
constexpr const char* kRunFile = "run.json";

/// The page that is made from a run's files, and is not one of them.
constexpr const char* kReportPage = "report.html";

/// A tool that a run called.
struct StageRecord {
  std::string name;                  //!< scan, clean, stretch, deviations, export
  std::vector<std::string> command;  //!< as it was called in the folder inputs
  int exit_code = 0;
  double seconds = 0;
};

/// A file in a run's folder.
struct FileEntry {
  std::string sha256;  //!< lower case hexadecimal digits
  std::uintmax_t bytes = 0;
};

/// Figures of a run. Lengths are metres; none: not known.
struct RunFigures {
  std::optional<double> scale, rms, largest_displacement, expected_error_normal,
      expected_error_tangential, expected_error_orientation;  // the last in rad
  std::optional<double> deviation_rms, deviation_min, deviation_max;
  std::map<std::string, std::optional<double>> places;  //!< deviation by the place's name
};

/// How a run ended.
enum class RunState { kAccepted, kRefused, kUnusable };

/// The word for it in files.
std::string to_string(RunState state);

/// Everything kept about a run besides its files (docs/part_recipes.md).
struct RunRecord {
  std::string id;
  std::string recipe_name;     //!< for people
  std::string recipe_folder;   //!< absolute
  std::string recipe_sha256;   //!< over the recipe's files
  std::string started, ended;  //!< UTC, as 2026-11-25T12:13:14.123Z
  std::string host;
  std::string version;  //!< of the suite
  RunState state = RunState::kUnusable;
  std::string reason;   //!< of the stretcher, or the stage that failed
  std::string message;  //!< for a person
  std::vector<StageRecord> stages;
  double tolerance = 0;    //!< [m] of the recipe
  std::string scan_units;  //!< of the raw cloud: m, mm or inch
  RunFigures figures;
  std::map<std::string, std::string> calibration;  //!< SHA-256 of scanner and cell file
  std::map<std::string, FileEntry> files;
  std::string again_of;        //!< id of the run that this one repeats; empty: none
  std::size_t path_edits = 0;  //!< by a person, to the adapted path
  std::string note;            //!< of the person
};

/// The text of run.json.
std::string to_json(const RunRecord& record);

/// Reads run.json of a run's folder.
/// @throw scan_cell_common::FileError if there is none
/// @throw scan_cell_common::UnusableInput if it is broken or from a newer version
RunRecord load_run(const std::filesystem::path& folder);

}  // namespace part_recipes
