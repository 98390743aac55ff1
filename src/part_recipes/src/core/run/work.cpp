// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include "run/run_recipe.h"
#include "run/stage_calls.h"
#include "run/tool_call.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

/// @return whether it was done whole
bool work_once(const Recipe& recipe, const RunRequest& request, bool dry, EndedRun& ended) {
  const std::string beside = ended.folder.string() + (dry ? ".dry_run" : ".work");
  const fs::path log = beside + ".log";
  const ToolCall call = work_call(recipe, ended.folder, dry, beside + ".json", request.timeout);
  const int code = run_tool(call, ended.folder.parent_path(), log, request.stop).exit_code;
  ended.work_message = last_line(log);
  fs::remove(log);
  return code == 0;
}

}  // namespace

void work(const Recipe& recipe, const RunRequest& request, const StageBegins& begins,
          EndedRun& ended) {
  if (request.work == Work::kNone || ended.record.state != RunState::kAccepted) return;
  if (begins) begins("dry_run");
  ended.worked = work_once(recipe, request, true, ended);
  if (!ended.worked || request.work == Work::kDry) return;
  if (begins) begins("work");
  ended.worked = work_once(recipe, request, false, ended);
}

}  // namespace part_recipes
