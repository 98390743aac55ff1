// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run/again.h"

#include <set>

#include "run/calls/stage_calls.h"
#include "run/run_folder.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

fs::path scan_in(const fs::path& inputs) {
  for (const auto& entry : fs::directory_iterator(inputs)) {
    if (entry.path().stem() == "scan" && entry.path().filename() != "scan.json")
      return entry.path();
  }
  throw scan_cell_common::UnusableInput(inputs.string(), "has no scan",
                                        "give a run whose scan was completed");
}

bool is_result(const std::string& name) {
  return name.rfind("stages/", 0) != 0;
}

/// The scan of a run, if nobody changed it.
RunRequest request_of(const fs::path& folder, const fs::path& runs, const Stop& stop) {
  const RunRecord before = load_run(folder);
  check_files(folder, before);
  RunRequest request;
  request.runs = runs;
  request.scan = scan_in(folder / "inputs");
  request.scan_units = before.scan_units;
  if (fs::exists(folder / "scan.json")) request.scan_record = folder / "scan.json";
  if (fs::exists(folder / "inputs" / kScannerModel))
    request.scanner = folder / "inputs" / kScannerModel;
  if (fs::exists(folder / "inputs" / kPathEdits))
    request.path_edits = tool_paths::load_path_edits((folder / "inputs" / kPathEdits).string());
  request.prove = true;  // a recorded run may be repeated
  request.again_of = before.id;
  request.recipe_folder = before.recipe_folder;
  request.note = before.note;
  request.stop = stop;
  return request;
}

}  // namespace

namespace {

EndedRun run_from(const fs::path& folder, RunRequest request, const StageBegins& begins) {
  if (fs::exists(folder / "scan.bag")) request.scan_bag = folder / "scan.bag";
  return run_recipe(load_recipe(folder / "inputs"), request, begins);
}

}  // namespace

EndedRun run_again(const fs::path& folder, const fs::path& runs, const StageBegins& begins,
                   const Stop& stop) {
  return run_from(folder, request_of(folder, runs, stop), begins);
}

EndedRun run_edited(const fs::path& folder, const std::vector<tool_paths::PathEdit>& edits,
                    const fs::path& runs, const std::string& note, const StageBegins& begins,
                    const Stop& stop) {
  const RunRecord before = load_run(folder);
  if (before.state != RunState::kAccepted)
    throw scan_cell_common::Refused("run " + before.id, to_string(before.state),
                                    "only an accepted path can be edited");
  RunRequest request = request_of(folder, runs, stop);
  request.path_edits.insert(request.path_edits.end(), edits.begin(), edits.end());
  if (!note.empty()) request.note = note;
  return run_from(folder, request, begins);
}

EndedRun run_with(const fs::path& folder, const Recipe& recipe, const fs::path& runs,
                  const Stop& stop) {
  RunRequest request = request_of(folder, runs, stop);
  request.path_edits.clear();  // they count the waypoints of the recorded recipe's path
  return run_recipe(recipe, request, {});
}

std::vector<std::string> differences(const fs::path& one, const fs::path& other) {
  const auto first = load_run(one).files;
  const auto second = load_run(other).files;
  std::set<std::string> names;
  for (const auto& files : {first, second}) {
    for (const auto& [name, file] : files) {
      if (is_result(name)) names.insert(name);
    }
  }
  std::vector<std::string> different;
  for (const std::string& name : names) {
    const bool both = first.count(name) != 0 && second.count(name) != 0;
    const bool same = both && first.at(name).sha256 == second.at(name).sha256;
    if (!same) different.push_back(name);
  }
  return different;
}

}  // namespace part_recipes
