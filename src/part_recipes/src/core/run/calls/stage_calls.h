// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "recipe/proof.h"
#include "recipe/recipe.h"
#include "run/calls/tool_call.h"

namespace part_recipes {

/// In inputs: the scanner model of the scan.
constexpr const char* kScannerModel = "scanner_model.yaml";

/// The tools that a run calls, in their order. They work in its folder inputs; what they write goes
/// one folder up, so that the names in reports and logs are valid wherever the run is copied.

/// The running cell scans: inputs/scan.ply, scan.json.
/// @param calibration hashes of the files with which it must be calibrated; empty: any
/// @param bag whether to keep what replay needs: scan.bag
/// @param timeout [s] to wait for the cell
ToolCall scan_call(const Recipe& recipe, const Hashes& calibration, bool bag, double timeout);

/// object.ply.
/// @param scan raw cloud in inputs @param units of its lengths
ToolCall clean_call(const Recipe& recipe, const std::string& scan, const std::string& units);

/// In inputs: the edits of the adapted path by a person.
constexpr const char* kPathEdits = "path_edits.yaml";

/// Folder in the run's folder for the results of stretch, if a person edits them.
constexpr const char* kUnedited = "unedited";

/// report.json, and the adapted path if it is accepted.
/// @param into the run's folder, seen from inputs, or a folder in it
ToolCall stretch_call(const Recipe& recipe, const std::string& into = "..");

/// The adapted path and report.json, from those in kUnedited.
ToolCall edit_call(const Recipe& recipe);

/// sight.json: which waypoints the scan could see, and what hindered the others.
/// @param region options for the camera's region
/// @param report of stretch, seen from inputs
ToolCall sight_call(const Recipe& recipe, const std::vector<std::string>& region,
                    const std::string& report);

/// report.json of an accepted run's path, adapted from its own scan to another one: object.ply.
/// @param run its folder
ToolCall recheck_call(const Recipe& recipe, const std::filesystem::path& run);

/// deviation.ply, deviation.json.
ToolCall deviations_call(const Recipe& recipe);

/// Name of the adapted path in the run's folder; it has the format of the proven path.
std::string path_name(const Recipe& recipe);

/// programs/FILE.
ToolCall export_call(const Recipe& recipe, const RobotProgram& program);

/// The running cell works a sealed run.
/// @param run its folder
/// @param dry lifted, slow, tool off
/// @param record gets each waypoint that was passed
ToolCall work_call(const Recipe& recipe, const std::filesystem::path& run, bool dry,
                   const std::filesystem::path& record, double timeout);

/// Path of that program, from inputs.
std::string program_file(const RobotProgram& program);

/// The same work, as a preview only.
ToolCall preview_call(const Recipe& recipe, const std::filesystem::path& run, bool dry,
                      double timeout);

}  // namespace part_recipes
