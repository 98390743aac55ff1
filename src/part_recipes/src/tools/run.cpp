// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "history/remember.h"
#include "run/again.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/interrupts.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

using part_recipes::EndedRun;
using part_recipes::RunState;
using part_recipes::Work;
using scan_cell_common::CatchInterrupts;

struct Options {
  std::string name;
  std::string recipes = "recipes";
  std::string runs = "runs";
  std::string again;       // folder of a run
  std::string path_edits;  // file; empty: none
  std::string scan;
  part_recipes::RunRequest request;
};

void add_options(CLI::App& app, Options& options) {
  CLI::Option* const again =
      app.add_option("--again", options.again, "folder of a run: repeats it from its own files");
  app.add_option("--path-edits", options.path_edits,
                 "with --again: edits of the adapted path by hand (docs/editing_a_path.md)")
      ->needs(again);
  app.add_option("name", options.name, "recipe")->excludes(again);
  app.add_option("--recipes", options.recipes, "folder of the recipes")
      ->envname("SCAN_CELL_RECIPES")
      ->capture_default_str();
  app.add_option("--runs", options.runs, "folder of the runs")
      ->envname("SCAN_CELL_RUNS")
      ->capture_default_str();
  app.add_option("--scan", options.scan,
                 "raw cloud in the world's frame (PLY, PCD ...); without it the running cell scans")
      ->excludes(again);
  app.add_option("--scan-units", options.request.scan_units, "units of that cloud")
      ->check(CLI::IsMember(scan_cell_common::length_units()))
      ->capture_default_str();
  app.add_flag("--bag", options.request.bag, "keeps a bag of the scan in the run: scan.bag")
      ->excludes(again);
  app.add_option("--note", options.request.note, "note that is kept with the run");
  const std::map<std::string, Work> works = {{"dry", Work::kDry}, {"real", Work::kReal}};
  app.add_option("--work", options.request.work,
                 "what the running cell does with an accepted path: dry (lifted, slow, tool off) "
                 "or real, which it refuses until the recipe's path was run dry")
      ->transform(CLI::CheckedTransformer(works))
      ->excludes(again);
  app.add_option("--timeout", options.request.timeout, "seconds to wait for the cell")
      ->capture_default_str();
}

/// Prints one line per stage; on a terminal, always the same line.
void show(const std::string& stage) {
  const bool terminal = isatty(STDERR_FILENO) == 1;
  std::fprintf(stderr, terminal ? "\r\033[K%s ..." : "%s ...\n", stage.c_str());
  std::fflush(stderr);
}

/// @return the process's exit code
int tell(const EndedRun& ended) {
  if (isatty(STDERR_FILENO) == 1) std::fputs("\r\033[K", stderr);
  const auto& record = ended.record;
  if (!ended.warning.empty()) std::fprintf(stderr, "warning: %s\n", ended.warning.c_str());
  for (const auto& stage : record.stages)
    std::printf("%-12s %6.2f s\n", stage.name.c_str(), stage.seconds);
  std::printf("%s: %s\n", to_string(record.state).c_str(), record.message.c_str());
  std::printf("%s\n", (ended.folder / part_recipes::kReportPage).c_str());
  if (!ended.work_message.empty())
    std::fprintf(ended.worked ? stdout : stderr, "%s\n", ended.work_message.c_str());
  switch (record.state) {
    case RunState::kAccepted:
      return ended.worked || ended.work_message.empty() ? 0 : scan_cell_common::kUnusable;
    case RunState::kRefused:
      return scan_cell_common::kRefused;
    case RunState::kUnusable:
      break;
  }
  return scan_cell_common::kUnusable;
}

/// @return the process's exit code
int run_edited(const Options& options) {
  EndedRun ended = part_recipes::run_edited(
      options.again, tool_paths::load_path_edits(options.path_edits), options.runs,
      options.request.note, show, CatchInterrupts::interrupted);
  remember(ended);
  return tell(ended);
}

/// @return the process's exit code
int run_again(const Options& options) {
  EndedRun ended =
      part_recipes::run_again(options.again, options.runs, show, CatchInterrupts::interrupted);
  remember(ended);
  const int code = tell(ended);
  const auto different = part_recipes::differences(options.again, ended.folder);
  if (different.empty()) {
    std::printf("the same bytes as %s\n", options.again.c_str());
    return code;
  }
  for (const std::string& name : different)
    std::fprintf(stderr, "%s is not the same\n", name.c_str());
  return scan_cell_common::kRefused;
}

/// @return the process's exit code
int run(Options& options) {
  const CatchInterrupts interrupts;
  if (!options.path_edits.empty()) return run_edited(options);
  if (!options.again.empty()) return run_again(options);
  if (options.name.empty())
    throw scan_cell_common::InvalidParameter("recipe", "not given", "give its name: run NAME");
  options.request.runs = options.runs;
  options.request.stop = CatchInterrupts::interrupted;
  if (!options.scan.empty()) options.request.scan = options.scan;
  const auto folder = part_recipes::find_recipe(options.recipes, options.name);
  const part_recipes::Recipe recipe = part_recipes::load_recipe(folder);
  EndedRun ended = part_recipes::run_recipe(recipe, options.request, show);
  remember(ended);
  part_recipes::work(recipe, options.request, show, ended);
  return tell(ended);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Scans a part by its recipe, cleans, adapts the path, writes the robot's programs and the "
      "report.\n"
      "Exit code 0: accepted, and worked where asked; 2: refused, the report says why; 1: it "
      "failed.");
  Options options;
  add_options(app, options);
  return scan_cell_common::tool_main(
      "run", app, argc, argv, [&] { return run(options); }, scan_cell_common::kRefused);
}
