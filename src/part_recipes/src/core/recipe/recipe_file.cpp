// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "recipe/recipe.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/pose/units.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using scan_cell_common::YamlEntry;

constexpr int kRecipeFormat = 1;

/// Files must move with the recipe's folder, and a program must not be written outside of it.
std::string file_within(const YamlEntry& entry) {
  const auto name = entry.as<std::string>();
  const fs::path path(name);
  bool inside = !name.empty() && path.is_relative() && path.has_filename();
  for (const fs::path& part : path)
    inside = inside && part != ".." && part.string().front() != '.';
  if (!inside) entry.refuse(fmt::format("'{}'", name), "name a file in the recipe's folder");
  return name;
}

std::string optional_file(const YamlEntry& root, const std::string& key) {
  return root.has(key) ? file_within(root[key]) : "";
}

ToolOptions options_of(const YamlEntry& owner, const std::string& key) {
  if (!owner.has(key)) return {};
  return owner[key].as<ToolOptions>();
}

RecipeFile described_file(const YamlEntry& entry) {
  entry.refuse_unknown({"file", "units", "options"});
  RecipeFile result;
  result.file = file_within(entry["file"]);
  result.units = entry["units"].as<std::string>();
  const auto units = scan_cell_common::length_units();
  if (std::find(units.begin(), units.end(), result.units) == units.end())
    entry["units"].refuse(result.units, fmt::format("give one of {}", fmt::join(units, ", ")));
  result.options = options_of(entry, "options");
  return result;
}

double length(const YamlEntry& entry) {
  constexpr double kLongest = 1;  // [m] a tolerance above it is in another unit
  const auto value = entry.as<double>();
  if (!(value > 0 && value <= kLongest))
    entry.refuse(fmt::format("{}", value), "give metres, above 0 and up to 1");
  return value;
}

std::vector<Place> places_of(const YamlEntry& list) {
  std::vector<Place> places;
  std::set<std::string> names;
  for (const YamlEntry& entry : list.elements()) {
    entry.refuse_unknown({"name", "position", "radius"});
    Place place;
    place.name = entry["name"].as<std::string>();
    if (place.name.empty() || !names.insert(place.name).second)
      entry["name"].refuse(fmt::format("'{}'", place.name), "give each place its own name");
    place.position = entry["position"].vector<3>();
    if (entry.has("radius")) place.radius = length(entry["radius"]);
    places.push_back(std::move(place));
  }
  return places;
}

std::vector<RobotProgram> programs_of(const YamlEntry& list) {
  std::vector<RobotProgram> programs;
  std::set<std::string> names;
  for (const YamlEntry& entry : list.elements()) {
    entry.refuse_unknown({"file", "options"});
    const std::string file = file_within(entry["file"]);
    if (!names.insert(file).second) entry["file"].refuse(file, "name each program once");
    programs.push_back({file, options_of(entry, "options")});
  }
  return programs;
}

std::string name_of(const YamlEntry& entry) {
  const auto name = entry.as<std::string>();
  if (name.empty()) entry.refuse("empty", "give the part type a name");
  return name;
}

CheckPass check_pass_of(const YamlEntry& entry) {
  entry.refuse_unknown({"program", "tolerance"});
  CheckPass check;
  check.program = file_within(entry["program"]);
  if (entry.has("tolerance")) check.tolerance = length(entry["tolerance"]);
  return check;
}

void check_format(const YamlEntry& entry) {
  const int format = entry.as<int>();
  if (format != kRecipeFormat)
    entry.refuse(fmt::format("format {}", format), "this version reads format 1");
}

Recipe parse_recipe(const YamlEntry& root) {
  root.refuse_unknown({"recipe", "name", "program", "cleaning", "reference", "path", "stretch",
                       "tolerance", "places", "robot_programs", "work", "check"});
  check_format(root["recipe"]);
  Recipe recipe;
  recipe.name = name_of(root["name"]);
  recipe.program = optional_file(root, "program");
  recipe.cleaning = optional_file(root, "cleaning");
  recipe.reference = described_file(root["reference"]);
  recipe.path = described_file(root["path"]);
  recipe.stretch = options_of(root, "stretch");
  recipe.tolerance = length(root["tolerance"]);
  if (root.has("places")) recipe.places = places_of(root["places"]);
  if (root.has("robot_programs")) recipe.programs = programs_of(root["robot_programs"]);
  if (root.has("work")) root["work"].refuse_unknown({"waypoint_z", "frame"});
  recipe.work = options_of(root, "work");
  if (root.has("check")) recipe.check = check_pass_of(root["check"]);
  return recipe;
}

}  // namespace

bool is_robot_program(const RecipeFile& path) {
  const std::string extension = scan_cell_common::extension_of(path.file);
  return extension != ".csv" && extension != ".yaml" && extension != ".yml";
}

Recipe parse_recipe(const std::string& text, const std::string& name) {
  return parse_recipe(YamlEntry::parse(text, name));
}

Recipe load_recipe(const fs::path& folder) {
  Recipe recipe = parse_recipe(YamlEntry::load((folder / kRecipeFile).string()));
  recipe.folder = folder;
  return recipe;
}

}  // namespace part_recipes
