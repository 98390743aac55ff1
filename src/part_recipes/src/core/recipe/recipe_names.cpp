// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "recipe/recipe.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace part_recipes {

namespace fs = std::filesystem;

using scan_cell_common::FileError;
using scan_cell_common::InvalidParameter;

void check_name(const std::string& name) {
  constexpr std::size_t kLongest =
      100;  // [bytes] with the time of a run it stays below NAME_MAX, 255
  const auto refuse = [&name](const std::string& cure) {
    throw InvalidParameter("recipe name", fmt::format("'{}'", scan_cell_common::excerpt(name)),
                           cure);
  };
  if (name.empty()) refuse("give a name");
  if (name.size() > kLongest) refuse(fmt::format("give at most {} bytes", kLongest));
  if (name.front() == '.') refuse("begin with a letter or a digit, not with a dot");
  const bool odd = std::any_of(name.begin(), name.end(), [](char letter) {
    return letter == '/' || letter == '\\' || static_cast<unsigned char>(letter) < ' ';
  });
  if (odd) refuse("give the name of one folder, without slashes and control characters");
}

std::vector<std::string> recipe_names(const fs::path& recipes) {
  std::vector<std::string> names;
  try {
    for (const auto& entry : fs::directory_iterator(recipes)) {
      if (fs::is_regular_file(entry.path() / kRecipeFile))
        names.push_back(entry.path().filename().string());
    }
  } catch (const fs::filesystem_error& error) {
    throw FileError(recipes.string(), error.code().message(), "give the folder of your recipes");
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> recipe_names_so_far(const fs::path& recipes) {
  std::error_code unreadable;  // then recipe_names() says why
  const bool is_missing = !fs::exists(recipes, unreadable) && !unreadable;
  return is_missing ? std::vector<std::string>() : recipe_names(recipes);
}

fs::path find_recipe(const fs::path& recipes, const std::string& name) {
  check_name(name);
  if (fs::is_regular_file(recipes / name / kRecipeFile)) return recipes / name;
  const auto names = recipe_names(recipes);
  throw FileError((recipes / name).string(), "no recipe",
                  names.empty() ? "make one: recipe new"
                                : fmt::format("existing recipes: {}", fmt::join(names, ", ")));
}

std::vector<std::string> Recipe::files() const {
  std::vector<std::string> names = {kRecipeFile};
  const std::string check_program = check ? check->program : "";
  for (const std::string& file : {program, cleaning, reference.file, path.file, check_program}) {
    const bool is_known = std::find(names.begin(), names.end(), file) != names.end();
    if (!file.empty() && !is_known) names.push_back(file);
  }
  return names;
}

std::string Recipe::frame() const {
  const auto frame = work.find("frame");
  return frame == work.end() ? "world" : frame->second;
}

}  // namespace part_recipes
