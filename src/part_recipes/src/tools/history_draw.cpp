// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history_draw.h"

#include "run/calls/tool_call.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/temporary_folder.h"

namespace fs = std::filesystem;

using scan_cell_common::FileError;

void draw_chart(const std::string& data, const fs::path& output) {
  const scan_cell_common::TemporaryFolder folder("history_chart");
  const fs::path figures = folder.path() / "figures.json", log = folder.path() / "log";
  scan_cell_common::save_text(figures.string(), data);
  const part_recipes::ToolCall call = {
      "chart",
      "part_recipes",
      {"history_chart.py", figures.string(), "--output", fs::absolute(output).string()}};
  const auto never = [] { return false; };
  if (part_recipes::run_tool(call, folder.path(), log, never).exit_code == 0) return;
  throw FileError(output.string(), "not drawn: " + part_recipes::last_line(log),
                  "check the folder, and that python3-matplotlib is installed");
}
