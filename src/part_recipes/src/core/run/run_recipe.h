// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "recipe/recipe.h"
#include "record/run_record.h"
#include "tool_paths/path_edits.h"

namespace part_recipes {

/// Whether the running cell works the part of an accepted run.
enum class Work {
  kNone,
  kDry,   //!< lifted, slow, tool off
  kReal,  //!< refused by the cell until the recipe's path was run dry there
};

/// Inputs of a run besides its recipe.
struct RunRequest {
  std::filesystem::path runs;  //!< folder of all runs
  std::optional<std::filesystem::path>
      scan;                      //!< raw cloud in the world's frame; none: the running cell scans
  std::string scan_units = "m";  //!< of that cloud
  std::optional<std::filesystem::path>
      scan_record;                                //!< what the cell said of that cloud: scan.json
  std::optional<std::filesystem::path> scan_bag;  //!< of that scan: scan.bag
  std::optional<std::filesystem::path> scanner;   //!< scanner model of that scan
  double timeout = 10;                            //!< [s] to wait for the cell
  bool bag = false;                               //!< whether to keep a bag of the scan
  Work work = Work::kNone;                        //!< what follows an accepted run
  bool prove = false;                             //!< the recipe need not be proven
  std::string again_of;                           //!< id of the run that this one repeats
  std::vector<tool_paths::PathEdit> path_edits;   //!< what a person does to the adapted path
  std::string recipe_folder;   //!< of the recipe that the run it repeats had; empty: as it is
  std::string note;            //!< of the person
  std::function<bool()> stop;  //!< whether to end now; then there is no run
};

/// Called when a stage begins.
using StageBegins = std::function<void(const std::string& stage)>;

/// A run that has ended and is whole on the disk.
struct EndedRun {
  std::filesystem::path folder;
  RunRecord record;
  std::string warning;       //!< what the person should know; empty: nothing
  bool worked = false;       //!< as far as it was asked for
  std::string work_message;  //!< how that ended; empty: nothing was asked for

  /// Adds to the warning; an empty text adds nothing.
  void warn(const std::string& text) {
    if (!text.empty()) warning += (warning.empty() ? "" : "; ") + text;
  }
};

/// Scans (unless a cloud is given), cleans, adapts, measures the deviations, writes the robot's
/// programs, and seals all of it as one folder (docs/part_recipes.md). A refusal is a run, too, and
/// so is a stage that failed.
/// @throw scan_cell_common::Refused if the recipe is not as it was proven, or the run was stopped:
/// there is no run then
/// @throw scan_cell_common::FileError if the run cannot be written: there is no run then
EndedRun run_recipe(const Recipe& recipe, const RunRequest& request, const StageBegins& begins);

/// Works the part of an accepted run, if the request asks for it, and adds to the run how that
/// ended. The passed waypoints are kept beside the run's folder, which stays as it was sealed:
/// ID.dry_run.json, ID.work.json, the second time ID.work_2.json; if it failed, also .log. Nothing
/// happens if the run was not accepted.
/// @throw scan_cell_common::FileError if the tool cannot be called
void work(const Recipe& recipe, const RunRequest& request, const StageBegins& begins,
          EndedRun& ended);

/// Shows on scan_cell's ~work_preview how the robot would work the part of a run, whether or not it
/// can. Nothing moves.
/// @param timeout [s] to wait for the cell
/// @param stop whether to end now
/// @throw scan_cell_common::Refused if the cell cannot make the preview
void preview_work(const Recipe& recipe, const std::filesystem::path& run, bool dry, double timeout,
                  const std::function<bool()>& stop);

}  // namespace part_recipes
