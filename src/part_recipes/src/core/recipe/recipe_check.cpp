// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "recipe/recipe_check.h"

#include <fmt/format.h>

#include <cstdint>
#include <functional>

#include "cloud_preprocess/clean.h"
#include "recipe/proof.h"
#include "scan_cell/scan_program.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/geometry/point_tree.h"
#include "scan_cell_common/parameters/parameter_table.h"
#include "scan_cell_common/pose/units.h"
#include "tool_path_stretcher/stretch_parameters.h"
#include "tool_path_stretcher/surface.h"
#include "tool_paths/tool_path_files.h"

namespace part_recipes {
namespace {

using scan_cell_common::UnusableInput;
using tool_path_stretcher::StretchParameters;

/// Takes the recipe's value for each parameter of stretch, and knows which are left.
class GivenParameters final : public scan_cell_common::ParameterTable {
 public:
  explicit GivenParameters(const ToolOptions& given) : left_(given) {}
  const ToolOptions& left() const { return left_; }

 private:
  void visit(const scan_cell_common::Parameter& parameter,
             scan_cell_common::ParameterValue&) override {
    left_.erase(parameter.name);
  }
  bool is_given(const std::string& old, const std::string&) override {
    return left_.count(old) != 0;
  }
  std::string named(const std::string& name) const override { return "stretch." + name; }

  ToolOptions left_;
};

void check_stretch(const Recipe& recipe) {
  GivenParameters table(recipe.stretch);
  StretchParameters parameters;
  describe(table, parameters);
  if (!table.left().empty())
    throw UnusableInput("stretch." + table.left().begin()->first, "no such parameter",
                        "see docs/tool_path_stretcher.md");
}

/// Refuses a path that does not lie on the part: it belongs to another one.
void check_path(const Recipe& recipe) {
  const StretchParameters parameters;
  const auto file = (recipe.folder / recipe.reference.file).string();
  const auto surface = tool_path_stretcher::load_surface(
      file, parameters.leaf, scan_cell_common::metres_per(recipe.reference.units));
  if (is_robot_program(recipe.path)) return;  // stretch reads it, with its frames
  tool_paths::PathConventions conventions;
  conventions.units = recipe.path.units;
  const auto path =
      tool_paths::load_tool_path_file((recipe.folder / recipe.path.file).string(), conventions)
          .path;
  const double limit = parameters.max_stand_off;
  const scan_cell_common::PointTree tree(surface.points);
  std::size_t near = 0, all = 0;
  for (const auto& position : tool_paths::positions_of(path)) {
    ++all;
    std::uint32_t index = 0;
    double squared = limit * limit;
    const double before = squared;
    tree.nearest_within(position.data(), index, squared);
    if (squared < before) ++near;
  }
  if (2 * near < all)
    throw UnusableInput(recipe.path.file,
                        fmt::format("{} of {} waypoints are farther than {} mm from the reference",
                                    all - near, all, 1e3 * parameters.max_stand_off),
                        "give the path that was proven on this reference, and its units");
}

}  // namespace

std::vector<std::string> problems_of(const Recipe& recipe) {
  std::vector<std::string> problems;
  const auto look = [&problems](const std::function<void()>& check) {
    try {
      check();
    } catch (const scan_cell_common::Error& error) {
      problems.emplace_back(error.what());
    }
  };
  look([&] {
    if (!recipe.program.empty()) scan_cell::load_scan_program(recipe.folder / recipe.program);
  });
  look([&] {
    if (recipe.check) scan_cell::load_scan_program(recipe.folder / recipe.check->program);
  });
  look([&] {
    if (!recipe.cleaning.empty())
      cloud_preprocess::load_clean_parameters(recipe.folder / recipe.cleaning);
  });
  look([&] { check_stretch(recipe); });
  look([&] { check_path(recipe); });
  look([&] { check_unchanged(recipe, load_proof(recipe), hashes_of(recipe)); });
  return problems;
}

}  // namespace part_recipes
