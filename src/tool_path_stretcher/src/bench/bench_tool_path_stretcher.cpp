// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "case_table.h"
#include "cases/case_list.h"
#include "growth.h"
#include "registration.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tool_path_stretcher/surface.h"
#include "tool_paths/tool_path_files.h"

namespace {

std::vector<cases::Case> cases_named(const std::string& word, const std::string& data) {
  std::vector<cases::Case> all = cases::all_cases(data);
  const auto other = [&word](const cases::Case& each) {
    return each.name.find(word) == std::string::npos;
  };
  all.erase(std::remove_if(all.begin(), all.end(), other), all.end());
  return all;
}

/// Writes the case as input of the stretch command.
void write(const cases::Case& each, const std::filesystem::path& folder) {
  const cases::Scene scene = cases::scene_of(each);
  std::filesystem::create_directories(folder);
  scan_cell_common::save_cloud((folder / "reference.ply").string(),
                               tool_path_stretcher::to_cloud(scene.reference));
  scan_cell_common::save_cloud((folder / "object.ply").string(),
                               tool_path_stretcher::to_cloud(scene.object));
  tool_paths::save_tool_path((folder / "path.csv").string(), scene.path);
  tool_paths::save_tool_path((folder / "truth.csv").string(), scene.truth);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Figures of the stretcher beside their yardsticks. Without options: all of them.");
  std::string word, folder;
  std::size_t growth_of = 0;
  bool only_registration = false, only_growth = false, reduced = false, only_ours = false;
  app.add_option("--cases", word, "only the cases whose name contains this");
  app.add_flag("--only-ours", only_ours, "the cases without the yardsticks beside them");
  app.add_option("--write", folder, "write clouds and path of the first such case here instead");
  app.add_option("--growth-of", growth_of, "only this size of the growth, in this process");
  app.add_flag("--reduced", reduced, "with --growth-of: on the default grid");
  app.add_flag("--registration", only_registration, "only car and bunny");
  app.add_flag("--growth", only_growth, "only the growth");
  return scan_cell_common::tool_main("bench_tool_path_stretcher", app, argc, argv, [&] {
    const char* variable = std::getenv("SCAN_CELL_DATA");
    const std::string data = variable == nullptr ? "" : variable;
    if (growth_of > 0) {
      bench::run_growth(growth_of, reduced);
      return 0;
    }
    const std::vector<cases::Case> chosen = cases_named(word, data);
    if (!folder.empty()) {
      if (chosen.empty()) return 1;
      write(chosen.front(), folder);
      return 0;
    }
    if (data.empty()) {
      std::printf("Without the real parts: SCAN_CELL_DATA does not name a folder with parts/\n");
    }
    if (!only_registration && !only_growth) bench::print_case_table(chosen, !only_ours);
    if (word.empty() && !only_growth) bench::print_registration(data);
    if (word.empty() && !only_registration) bench::print_growth();
    return 0;
  });
}
