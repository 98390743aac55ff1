// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include "record/record_names.h"
#include "run/calls/stage_calls.h"
#include "run/calls/tool_call.h"
#include "run/place_check.h"
#include "run/run_recipe.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {
void work(const Recipe& recipe, const RunRequest& request, const StageBegins& begins,
          EndedRun& ended) {
  if (request.work == Work::kNone || ended.record.state != RunState::kAccepted) return;
  const bool dry = request.work == Work::kDry;
  if (!dry && recipe.check) {
    const PlaceCheck place = check_place(recipe, ended.folder, request, begins);
    ended.work_message = place.message;
    if (!place.lies_there) return;
  }
  if (begins) begins(dry ? "dry_run" : "work");
  const std::string beside = free_name(ended.folder.string() + (dry ? ".dry_run" : ".work"));
  const std::filesystem::path log = beside + ".log";
  const ToolCall call = work_call(recipe, ended.folder, dry, beside + ".json", request.timeout);
  const int code = run_tool(call, ended.folder.parent_path(), log, request.stop).exit_code;
  ended.worked = code == 0;
  ended.work_message = last_line(log);
  if (ended.worked) std::filesystem::remove(log);
}

void preview_work(const Recipe& recipe, const std::filesystem::path& run, bool dry, double timeout,
                  const std::function<bool()>& stop) {
  const std::filesystem::path log = free_name(run.string() + ".preview") + ".log";
  const ToolCall call = preview_call(recipe, run, dry, timeout);
  const int code = run_tool(call, run.parent_path(), log, stop).exit_code;
  const std::string said = last_line(log);
  std::filesystem::remove(log);
  constexpr int kCannotFollow = 2;  // preview_work --help
  if (code != 0 && code != kCannotFollow)
    throw scan_cell_common::Refused(
        "preview of " + run.filename().string(), said,
        "is the cell running, and the run accepted? see docs/scan_cell.md");
}

}  // namespace part_recipes
