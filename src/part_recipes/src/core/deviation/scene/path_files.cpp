// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "deviation/scene/path_files.h"

#include "tool_path_programs/program_files.h"
#include "tool_path_programs/program_path.h"
#include "tool_paths/tool_path_files.h"

namespace part_recipes {

tool_paths::ToolPathFile load_path(const std::string& file, const PathReading& reading) {
  const tool_path_programs::Language* language = tool_path_programs::language_of(file);
  if (language == nullptr) return tool_paths::load_tool_path_file(file, reading.conventions);
  tool_path_programs::ReadSettings settings;
  settings.dialect = reading.dialect;
  settings.calls_without_motion = reading.calls_without_motion;
  tool_path_programs::ProgramPathSettings path;
  path.in_base = reading.program_in_base;
  const auto files = tool_path_programs::load_program(*language, file, reading.program_files);
  return {path_of(language->read(files, settings), path).path, {}};
}

}  // namespace part_recipes
