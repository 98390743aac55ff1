// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "recipe/recipe_edits.h"

#include <map>
#include <sstream>

#include "clock/utc_time.h"
#include "cloud_preprocess/clean.h"
#include "cloud_preprocess/cloud_edits.h"
#include "recipe/proof.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/yaml_file.h"

namespace part_recipes {
namespace {

using cloud_preprocess::CleanParameters;
using scan_cell_common::YamlEntry;

constexpr const char* kCleaningFile = "cleaning.yaml";  // of a recipe that had none

/// Settings without one section of their top level. Comments and blank lines before the next
/// section stay.
std::string without(const std::string& section, const std::string& settings) {
  std::istringstream lines(settings);
  std::string kept, between;
  bool within = false;
  for (std::string line; std::getline(lines, line);) {
    const bool blank = line.find_first_not_of(" \r") == std::string::npos;
    if (within && (blank || line[0] == '#')) {
      between += line + "\n";
      continue;
    }
    const bool belongs = !blank && std::string(" -]}").find(line[0]) != std::string::npos;
    within = line.rfind(section + ":", 0) == 0 || (within && belongs);
    if (!within) kept += between + line + "\n";
    between.clear();
  }
  return kept + between;
}

/// The list as this program writes it.
std::string checked(const std::string& edits) {
  if (edits.empty()) return "";
  const auto list = cloud_preprocess::read_edits(YamlEntry::parse(edits, "edits")["edits"]);
  return list.empty() ? "" : cloud_preprocess::to_yaml(list);
}

/// Sections by name, each as text.
std::map<std::string, std::string> sections_of(const CleanParameters& parameters) {
  const YAML::Node stages =
      scan_cell_common::parse_yaml(cloud_preprocess::stages_yaml(parameters), "stages");
  std::map<std::string, std::string> sections;
  for (const auto& entry : stages) {
    YAML::Emitter text;
    text << YAML::BeginMap << YAML::Key << entry.first << YAML::Value << entry.second
         << YAML::EndMap;
    sections[entry.first.as<std::string>()] = std::string(text.c_str()) + "\n";
  }
  return sections;
}

CleanParameters read_settings(const Recipe& recipe, const std::string& text) {
  return cloud_preprocess::read_clean_parameters(YamlEntry::parse(text, recipe.cleaning));
}

[[noreturn]] void refuse_way(const Recipe& recipe, const std::string& section) {
  throw scan_cell_common::UnusableInput(
      recipe.cleaning + ": " + section, "written in a way that cannot be changed here",
      "begin its line with " + section + ": and put nothing before it");
}

/// @throw scan_cell_common::Refused if its files were changed since it was made or proven
Proof proof_of_unchanged(const Recipe& recipe) {
  Proof proof = load_proof(recipe);
  check_unchanged(recipe, proof, hashes_of(recipe));
  return proof;
}

/// @param before proof before the change
void count_as_made(const Recipe& recipe, const Proof& before) {
  const Recipe changed = load_recipe(recipe.folder);
  save_proof(changed, {false, utc_now(), "", hashes_of(changed), before.calibration});
}

/// @param change made to the text of the settings
template <class Change>
void change_cleaning(const Recipe& recipe, const Change& change) {
  const Proof proof = proof_of_unchanged(recipe);
  const std::string file = recipe.cleaning.empty() ? kCleaningFile : recipe.cleaning;
  const std::string path = (recipe.folder / file).string();
  const std::string before = cleaning_of(recipe);
  const std::string after = change(before);
  if (!recipe.cleaning.empty() && after == before) return;
  scan_cell_common::save_text(path, after);
  if (recipe.cleaning.empty()) {
    const std::string all = (recipe.folder / kRecipeFile).string();
    scan_cell_common::save_text(all, scan_cell_common::read_file(all) + "cleaning: " + file + "\n");
  }
  count_as_made(recipe, proof);
}

}  // namespace

std::string cleaning_of(const Recipe& recipe) {
  if (recipe.cleaning.empty()) return "";
  return scan_cell_common::read_file((recipe.folder / recipe.cleaning).string());
}

void set_program(const Recipe& recipe, const scan_cell::ScanProgram& program) {
  if (recipe.program.empty())
    throw scan_cell_common::Refused("recipe '" + recipe.name + "'", "has no scan program",
                                    "make one that scans: recipe new --program");
  check({"", program.passes}, scan_cell::ScanLimits());
  const Proof proof = proof_of_unchanged(recipe);
  save_scan_program((recipe.folder / recipe.program).string(), program);
  count_as_made(recipe, proof);
}

void set_edits(const Recipe& recipe, const std::string& edits) {
  const std::string list = checked(edits);
  change_cleaning(recipe, [&](const std::string& before) {
    const std::string after = without("edits", before) + list;
    const auto now = read_settings(recipe, after).edits;
    if ((now.empty() ? "" : cloud_preprocess::to_yaml(now)) != list) refuse_way(recipe, "edits");
    return after;
  });
}

void set_stages(const Recipe& recipe, const std::string& stages) {
  const YamlEntry given = YamlEntry::parse(stages, "stages");
  given.refuse_unknown({"floor", "outliers", "isolate"});
  const auto wanted = sections_of(cloud_preprocess::read_clean_parameters(given));
  change_cleaning(recipe, [&](const std::string& before) {
    std::string after = before;
    const auto present = sections_of(read_settings(recipe, before));
    for (const auto& [name, section] : wanted)
      if (given.has(name) && present.at(name) != section) after = without(name, after) + section;
    const auto now = sections_of(read_settings(recipe, after));
    for (const auto& [name, section] : wanted)
      if (given.has(name) && now.at(name) != section) refuse_way(recipe, name);
    return after;
  });
}

}  // namespace part_recipes
