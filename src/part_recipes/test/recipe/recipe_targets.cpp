// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "recipe/recipe_targets.h"

#include <filesystem>
#include <set>

#include "recipe/recipe.h"

namespace {

using namespace scan_cell_common;
using part_recipes::Recipe;

const char* const kFull =
    "recipe: 1\nname: Platte groß\nprogram: program.yaml\ncleaning: cleaning.yaml\n"
    "reference: {file: reference.ply, units: mm}\n"
    "path:\n  file: paths/path.csv\n  units: m\n  options: {euler: zyz}\n"
    "stretch: {min_scale: 0.9, method: rigid}\ntolerance: 0.0005\n"
    "places:\n  - {name: rim, position: [0.1, -0.02, 0], radius: 0.004}\n"
    "  - {name: hole, position: [0, 0, 0.01]}\n"
    "robot_programs:\n  - file: plate.src\n    options: {waypoint_z: into_part}\n"
    "  - {file: plate.mod}\nwork: {waypoint_z: into_part}\n";

const char* const kLeast =
    "recipe: 1\nname: plate\nreference: {file: r.pcd, units: m}\n"
    "path: {file: p.csv, units: m}\ntolerance: 1.0e-3\n";

/// A copy of the recipe's folder holds the whole recipe, and a run writes nowhere else.
void expect_inside(const std::string& file) {
  const std::filesystem::path path(file);
  promise(!file.empty() && path.is_relative(), "a file in the recipe's folder");
  promise(*path.lexically_normal().begin() != "..", "a file in the recipe's folder");
}

/// An accepted recipe holds everything that is promised of a recipe.
void expect_usable(const Recipe& recipe) {
  promise(!recipe.name.empty(), "a name");
  promise(recipe.tolerance > 0 && recipe.tolerance <= 1, "a tolerance");
  for (const std::string& file : recipe.files())
    expect_inside(file);
  std::set<std::string> names;
  for (const part_recipes::Place& place : recipe.places) {
    promise(names.insert(place.name).second, "a name of its own");
    promise(place.position.allFinite() && place.radius > 0, "a place");
  }
  for (const part_recipes::RobotProgram& program : recipe.programs) {
    expect_inside(program.file);
    promise(names.insert("program " + program.file).second, "each program once");
  }
}

}  // namespace

std::vector<FuzzTarget> recipe_targets() {
  FuzzTarget target;
  target.name = "recipe";
  target.seeds = {kFull, kLeast};
  target.words = {"recipe", "name",   "program", "cleaning", "reference", "path",   "stretch",
                  "file",   "units",  "options", "places",   "position",  "radius", "tolerance",
                  "..",     "/",      "./",      "[",        "]",         "{",      "}",
                  "- ",     ": ",     "&p ",     "*p",       "<<",        "? ",     "|\n",
                  "#",      "~",      ".nan",    ".inf",     "0",         "-1",     "1e308",
                  "null",   "1e-320", "\t",      "---",      "[[[[[[[[",  "inch",   "''"};
  target.run = [](const std::string& bytes) {
    expect_usable(part_recipes::parse_recipe(bytes, "recipe.yaml"));
  };
  return {target};
}
