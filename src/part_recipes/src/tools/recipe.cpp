// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "history/remember.h"
#include "recipe/new_recipe.h"
#include "recipe/recipe_check.h"
#include "run/prove.h"
#include "run/recipe_picture.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/sha256.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/interrupts.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

using part_recipes::Recipe;

struct Options {
  std::string recipes = "recipes";
  part_recipes::NewRecipe made;
  std::vector<std::string> programs;
  std::vector<std::string> stretch, path_options, program_options, work;  // NAME=VALUE
  std::string scanner, cell;
};

part_recipes::ToolOptions options_of(const std::vector<std::string>& settings,
                                     const std::string& option) {
  part_recipes::ToolOptions options;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == 0 || equals == std::string::npos)
      throw scan_cell_common::InvalidParameter(option, setting, "give NAME=VALUE");
    options[setting.substr(0, equals)] = setting.substr(equals + 1);
  }
  return options;
}

void add_new(CLI::App& app, Options& options) {
  const CLI::IsMember units(scan_cell_common::length_units());
  auto& made = options.made;
  app.add_option("name", made.name, "name of the part type")->required();
  app.add_option("--reference", made.reference.file,
                 "the part that the path was proven on: clean cloud or mesh")
      ->required();
  app.add_option("--reference-units", made.reference.units)->check(units)->capture_default_str();
  app.add_option("--path", made.path.file, "tool path proven on it: CSV, YAML or a program")
      ->required();
  app.add_option("--path-units", made.path.units)->check(units)->capture_default_str();
  app.add_option("--path-option", options.path_options,
                 "NAME=VALUE: option of stretch and export_path that says how the path is written");
  app.add_option("--program", made.program, "scan program (YAML)");
  app.add_option("--cleaning", made.cleaning, "settings of clean_cloud (YAML)");
  app.add_option("--stretch", options.stretch, "NAME=VALUE: parameter of stretch");
  app.add_option("--tolerance", made.tolerance, "deviations within +- are good [m]")
      ->capture_default_str();
  app.add_option("--robot-program", options.programs, "program to write, such as part.src");
  app.add_option("--program-option", options.program_options,
                 "NAME=VALUE: option of export_path for all programs");
  app.add_option("--work", options.work, "NAME=VALUE: waypoint_z or frame, as work takes them");
  app.add_option("--check-program", made.check_program,
                 "scan program (YAML) that is run before the work: does the part still lie there?");
  app.add_option("--check-tolerance", made.check_tolerance,
                 "distance by which the part may have moved since it was scanned [m]")
      ->capture_default_str();
  app.add_option("--scanner", options.scanner, "scanner model that the reference was scanned with");
  app.add_option("--cell", options.cell, "cell file that the reference was scanned with");
}

int make(Options& options) {
  auto& made = options.made;
  made.stretch = options_of(options.stretch, "--stretch");
  made.work = options_of(options.work, "--work");
  made.path.options = options_of(options.path_options, "--path-option");
  for (const std::string& program : options.programs)
    made.programs.push_back({program, options_of(options.program_options, "--program-option")});
  if (!options.scanner.empty())
    made.calibration["scanner"] = scan_cell_common::sha256_of_file(options.scanner);
  if (!options.cell.empty())
    made.calibration["cell"] = scan_cell_common::sha256_of_file(options.cell);
  const Recipe recipe = make_recipe(options.recipes, made);
  const std::string fault = draw_picture(recipe);
  if (!fault.empty()) std::fprintf(stderr, "warning: %s\n", fault.c_str());
  std::printf("%s\n", (recipe.folder / part_recipes::kRecipeFile).c_str());
  return 0;
}

/// @return the process's exit code
int check(const Options& options) {
  const Recipe recipe =
      part_recipes::load_recipe(part_recipes::find_recipe(options.recipes, options.made.name));
  const auto problems = problems_of(recipe);
  for (const std::string& problem : problems)
    std::printf("%s\n", problem.c_str());
  if (problems.empty()) std::printf("nothing is missing or out of date\n");
  return problems.empty() ? 0 : scan_cell_common::kRefused;
}

int list(const Options& options) {
  for (const std::string& name : part_recipes::recipe_names(options.recipes)) {
    try {
      const Recipe recipe =
          part_recipes::load_recipe(part_recipes::find_recipe(options.recipes, name));
      const auto proof = load_proof(recipe);
      std::printf("%-24s %s %s\n", name.c_str(), proof.proven ? "proven" : "made  ",
                  proof.time.c_str());
    } catch (const scan_cell_common::Error& error) {
      std::printf("%-24s %s\n", name.c_str(), error.what());
    }
  }
  return 0;
}

/// @return the process's exit code
int prove(const Options& options, const part_recipes::RunRequest& request) {
  const Recipe recipe =
      part_recipes::load_recipe(part_recipes::find_recipe(options.recipes, options.made.name));
  auto ended = part_recipes::prove(recipe, request);
  remember(ended);
  if (!ended.warning.empty()) std::fprintf(stderr, "warning: %s\n", ended.warning.c_str());
  std::printf("%s\n", ended.folder.c_str());
  std::printf("proven: rms %.3f mm, tolerance %.3f mm\n", 1e3 * *ended.record.figures.deviation_rms,
              1e3 * recipe.tolerance);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Makes, checks, lists and proves recipes, one per part type.");
  app.require_subcommand(1);
  app.fallthrough();
  Options options;
  part_recipes::RunRequest request;
  std::string scan, runs = "runs";
  app.add_option("--recipes", options.recipes, "folder of the recipes")
      ->envname("SCAN_CELL_RECIPES")
      ->capture_default_str();
  auto* const make_one = app.add_subcommand("new", "makes one from a reference and a path");
  add_new(*make_one, options);
  auto* const check_one = app.add_subcommand("check", "says what is missing or out of date");
  check_one->add_option("name", options.made.name)->required();
  auto* const list_all = app.add_subcommand("list", "lists all, and whether they are proven");
  auto* const prove_one = app.add_subcommand(
      "prove", "runs it on the reference part, which has to be within tolerance");
  prove_one->add_option("name", options.made.name)->required();
  prove_one->add_option("--scan", scan,
                        "raw cloud of the reference part; without it the cell scans");
  prove_one->add_option("--scan-units", request.scan_units)
      ->check(CLI::IsMember(scan_cell_common::length_units()))
      ->capture_default_str();
  prove_one->add_option("--runs", runs, "folder of the runs")
      ->envname("SCAN_CELL_RUNS")
      ->capture_default_str();
  return scan_cell_common::tool_main(
      "recipe", app, argc, argv,
      [&] {
        if (make_one->parsed()) return make(options);
        if (check_one->parsed()) return check(options);
        if (list_all->parsed()) return list(options);
        const scan_cell_common::CatchInterrupts interrupts;
        request.stop = scan_cell_common::CatchInterrupts::interrupted;
        request.runs = runs;
        if (!scan.empty()) request.scan = scan;
        return prove(options, request);
      },
      scan_cell_common::kRefused);
}
