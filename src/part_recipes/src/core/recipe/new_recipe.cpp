// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "recipe/new_recipe.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "clock/utc_time.h"
#include "disk/to_disk.h"
#include "recipe/places_file.h"
#include "recipe/recipe_check.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using scan_cell_common::FileError;
using scan_cell_common::UnusableInput;

/// A folder with a dotted name until it is whole.
class Draft {
 public:
  Draft(const fs::path& recipes, const std::string& name)
      : whole_(recipes / name), draft_(recipes / ("." + name)) {
    if (fs::exists(whole_))
      throw FileError(whole_.string(), "already exists", "give another name, or remove it");
    fs::create_directories(recipes);
    if (!fs::create_directory(draft_))
      throw FileError(draft_.string(), "is left over from an unfinished recipe", "remove it");
  }
  ~Draft() {
    std::error_code failure;
    fs::remove_all(draft_, failure);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  const fs::path& path() const { return draft_; }

  /// @return name in the folder: `as` with the extension of the file
  std::string add(const std::string& file, const std::string& as) const {
    if (file.empty()) return "";
    const std::string name = as + scan_cell_common::extension_of(file);
    fs::copy_file(file, draft_ / name);
    return name;
  }

  void finish() const { fs::rename(draft_, whole_); }

 private:
  fs::path whole_, draft_;
};

void write(YAML::Emitter& text, const std::string& key, const ToolOptions& options) {
  if (options.empty()) return;
  text << YAML::Key << key << YAML::Value << YAML::BeginMap;
  for (const auto& [name, value] : options)
    text << YAML::Key << name << YAML::Value << YAML::DoubleQuoted << value;
  text << YAML::EndMap;
}

void write(YAML::Emitter& text, const std::string& key, const RecipeFile& file) {
  text << YAML::Key << key << YAML::Value << YAML::BeginMap << YAML::Key << "file" << YAML::Value
       << file.file << YAML::Key << "units" << YAML::Value << file.units;
  write(text, "options", file.options);
  text << YAML::EndMap;
}

void write(YAML::Emitter& text, const std::vector<RobotProgram>& programs) {
  if (programs.empty()) return;
  text << YAML::Key << "robot_programs" << YAML::Value << YAML::BeginSeq;
  for (const RobotProgram& program : programs) {
    text << YAML::BeginMap << YAML::Key << "file" << YAML::Value << program.file;
    write(text, "options", program.options);
    text << YAML::EndMap;
  }
  text << YAML::EndSeq;
}

std::string yaml_of(const Recipe& recipe) {
  YAML::Emitter text;
  text << YAML::Comment("Keys: docs/part_recipes.md. After a change: recipe prove");
  text << YAML::BeginMap << YAML::Key << "recipe" << YAML::Value << 1;
  text << YAML::Key << "name" << YAML::Value << YAML::DoubleQuoted << recipe.name << YAML::Auto;
  if (!recipe.program.empty()) text << YAML::Key << "program" << YAML::Value << recipe.program;
  if (!recipe.cleaning.empty()) text << YAML::Key << "cleaning" << YAML::Value << recipe.cleaning;
  write(text, "reference", recipe.reference);
  write(text, "path", recipe.path);
  write(text, "stretch", recipe.stretch);
  text << YAML::Key << "tolerance" << YAML::Value << fmt::format("{}", recipe.tolerance)
       << YAML::Comment("[m] deviations within +- are good");
  if (!recipe.places.empty()) {
    text << YAML::Key << "places" << YAML::Value;
    write(text, recipe.places);
  }
  write(text, recipe.programs);
  write(text, "work", recipe.work);
  if (recipe.check)
    text << YAML::Key << "check" << YAML::Value << YAML::BeginMap << YAML::Key << "program"
         << YAML::Value << recipe.check->program << YAML::Key << "tolerance" << YAML::Value
         << fmt::format("{}", recipe.check->tolerance) << YAML::EndMap;
  text << YAML::EndMap;
  return std::string(text.c_str()) + "\n";
}

/// Refuses the recipe's problems, except the missing proof, which it cannot have yet.
void refuse_problems(const Recipe& recipe) {
  const auto problems = problems_of(recipe);
  if (problems.empty()) return;
  throw UnusableInput("recipe '" + recipe.name + "'", problems.front(), "no recipe was made");
}

}  // namespace

Recipe make_recipe(const fs::path& recipes, const NewRecipe& made) {
  check_name(made.name);
  try {
    const Draft draft(recipes, made.name);
    Recipe recipe;
    recipe.folder = draft.path();
    recipe.name = made.name;
    recipe.program = draft.add(made.program, "program");
    recipe.cleaning = draft.add(made.cleaning, "cleaning");
    recipe.reference = made.reference;
    recipe.reference.file = draft.add(made.reference.file, "reference");
    recipe.path = made.path;
    recipe.path.file = draft.add(made.path.file, "path");
    recipe.tolerance = made.tolerance;
    recipe.stretch = made.stretch;
    recipe.places = made.places;
    recipe.programs = made.programs;
    recipe.work = made.work;
    if (!made.check_program.empty())
      recipe.check = CheckPass{draft.add(made.check_program, "check"), made.check_tolerance};
    scan_cell_common::save_text((draft.path() / kRecipeFile).string(), yaml_of(recipe));
    recipe = load_recipe(draft.path());
    save_proof(recipe, {false, utc_now(), "", hashes_of(recipe), made.calibration});
    refuse_problems(recipe);
    draft.finish();
  } catch (const fs::filesystem_error& error) {
    throw_file_error(error);
  }
  return load_recipe(recipes / made.name);
}

}  // namespace part_recipes
