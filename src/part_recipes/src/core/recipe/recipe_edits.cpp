// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "recipe/recipe_edits.h"

#include <sstream>

#include "clock/utc_time.h"
#include "cloud_preprocess/clean.h"
#include "cloud_preprocess/cloud_edits.h"
#include "recipe/proof.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/yaml_file.h"

namespace part_recipes {
namespace {

constexpr const char* kCleaningFile = "cleaning.yaml";  // of a recipe that had none

/// Settings without the list of edits at their top level.
std::string without_edits(const std::string& settings) {
  std::istringstream lines(settings);
  std::string kept;
  bool within = false;
  for (std::string line; std::getline(lines, line);) {
    const bool belongs = line.empty() || line[0] == ' ' || line[0] == '-';
    within = line.rfind("edits:", 0) == 0 || (within && belongs);
    if (!within) kept += line + "\n";
  }
  return kept;
}

/// The list as this program writes it.
std::string checked(const std::string& edits) {
  using scan_cell_common::YamlEntry;
  if (edits.empty()) return "";
  const auto list = cloud_preprocess::read_edits(YamlEntry::parse(edits, "edits")["edits"]);
  return list.empty() ? "" : cloud_preprocess::to_yaml(list);
}

}  // namespace

void set_edits(const Recipe& recipe, const std::string& edits) {
  const std::string list = checked(edits);
  const Proof proof = load_proof(recipe);
  check_unchanged(recipe, proof, hashes_of(recipe));
  const std::string file = recipe.cleaning.empty() ? kCleaningFile : recipe.cleaning;
  const std::string path = (recipe.folder / file).string();
  const std::string before = recipe.cleaning.empty() ? "" : scan_cell_common::read_file(path);
  scan_cell_common::save_text(path, without_edits(before) + list);
  cloud_preprocess::load_clean_parameters(path);
  if (recipe.cleaning.empty()) {
    const std::string all = (recipe.folder / kRecipeFile).string();
    scan_cell_common::save_text(all, scan_cell_common::read_file(all) + "cleaning: " + file + "\n");
  }
  const Recipe changed = load_recipe(recipe.folder);
  save_proof(changed, {false, utc_now(), "", hashes_of(changed), proof.calibration});
}

}  // namespace part_recipes
