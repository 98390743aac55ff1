// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace part_recipes {

/// The file in a recipe's folder that names all others.
constexpr const char* kRecipeFile = "recipe.yaml";

/// Options of a tool by name, as its command line takes them: "min_scale" is --min-scale.
using ToolOptions = std::map<std::string, std::string>;

/// A file of a recipe.
struct RecipeFile {
  std::string file;         //!< within the recipe's folder
  std::string units = "m";  //!< of its lengths: m, mm or inch
  ToolOptions options;      //!< of the tools that read it
};

/// A place of the part whose deviation is followed from run to run.
struct Place {
  std::string name;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  //!< [m] on the reference
  double radius = 0.005;                               //!< [m] of the points that count
};

/// A robot program that is made from the adapted path.
struct RobotProgram {
  std::string file;     //!< its extension tells the language
  ToolOptions options;  //!< of export_path
};

/// A short scan before the work, to check that the part still lies where it was scanned.
struct CheckPass {
  std::string program;        //!< scan program that sees all of the path
  double tolerance = 0.0005;  //!< [m] allowed for the part's motion and the path's change
};

/// Everything that one part type needs from scan to program. Lengths are metres.
struct Recipe {
  std::filesystem::path folder;        //!< where its files lie
  std::string name;                    //!< for people; any text
  std::string program;                 //!< scan program; empty: clouds are given to it
  std::string cleaning;                //!< settings of clean_cloud; empty: its defaults
  RecipeFile reference;                //!< cloud or mesh of the part on which the path was proven
  RecipeFile path;                     //!< proven on the reference
  ToolOptions stretch;                 //!< parameters of stretch
  double tolerance = 0.0005;           //!< [m] deviations within +- are good
  std::vector<Place> places;           //!< each with a name of its own
  std::vector<RobotProgram> programs;  //!< of an accepted path
  ToolOptions work;                    //!< of work: waypoint_z, frame
  std::optional<CheckPass> check;      //!< before each work; none: the part stays in place

  /// Names of the files in the folder that a run depends on; recipe.yaml is the first.
  std::vector<std::string> files() const;

  /// Frame in which the reference is shown and the path adapted and worked: that of work, else
  /// world.
  std::string frame() const;
};

/// Whether a path is a robot program, with frames of its own, rather than a table of waypoints.
bool is_robot_program(const RecipeFile& path);

/// Reads a recipe from text, without a folder.
/// @param name of the text in error messages
/// @throw as load_recipe()
Recipe parse_recipe(const std::string& text, const std::string& name);

/// Reads RECIPE/recipe.yaml (docs/part_recipes.md). The files that it names are not read.
/// @param folder of the recipe
/// @throw scan_cell_common::FileError if there is none
/// @throw scan_cell_common::UnusableInput with line and key of what is missing, unknown or wrong
Recipe load_recipe(const std::filesystem::path& folder);

/// The recipe of that name below a folder of recipes.
/// @param name of its folder
/// @throw scan_cell_common::InvalidParameter if the name would lead elsewhere
/// @throw scan_cell_common::FileError if there is no such recipe; names the existing ones
std::filesystem::path find_recipe(const std::filesystem::path& recipes, const std::string& name);

/// Names of the recipes below a folder, sorted.
/// @throw scan_cell_common::FileError if the folder cannot be read
std::vector<std::string> recipe_names(const std::filesystem::path& recipes);

/// The same; none if the folder does not exist yet: the first recipe makes it.
/// @throw scan_cell_common::FileError if the folder exists and cannot be read
std::vector<std::string> recipe_names_so_far(const std::filesystem::path& recipes);

/// @throw scan_cell_common::InvalidParameter unless the text can be the name of a folder: no
/// slashes, no dot in front, no control characters, at most 100 bytes
void check_name(const std::string& name);

}  // namespace part_recipes
