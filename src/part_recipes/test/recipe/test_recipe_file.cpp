// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "made_up_part.h"
#include "recipe/recipe.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {
namespace {

const char* const kWhole =
    "recipe: 1\n"
    "name: \"frame <b>\"\n"
    "program: program.yaml\n"
    "cleaning: cleaning.yaml\n"
    "reference: {file: reference.stl, units: mm}\n"
    "path: {file: path.csv, units: inch, options: {degrees: true}}\n"
    "stretch: {min_scale: 0.9}\n"
    "tolerance: 0.0004\n"
    "places:\n"
    "  - {name: left flank, position: [0.1, 0.2, 0.3], radius: 0.004}\n"
    "robot_programs:\n"
    "  - {file: part.src, options: {waypoint_z: into_part}}\n";

class ARecipeFile : public testing::Test {
 protected:
  Recipe load(const std::string& text) const {
    scan_cell_common::save_text((folder_.path() / kRecipeFile).string(), text);
    return load_recipe(folder_.path());
  }

  /// The error about the file with one piece of it replaced.
  std::string refusal(const std::string& from, const std::string& to) const {
    std::string text = kWhole;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    try {
      load(text);
    } catch (const scan_cell_common::UnusableInput& error) {
      return error.what();
    }
    return "not refused";
  }

  TemporaryFolder folder_;
};

TEST_F(ARecipeFile, IsReadWhole) {
  const Recipe recipe = load(kWhole);
  EXPECT_EQ(recipe.name, "frame <b>");
  EXPECT_EQ(recipe.program, "program.yaml");
  EXPECT_EQ(recipe.cleaning, "cleaning.yaml");
  EXPECT_EQ(recipe.reference.file, "reference.stl");
  EXPECT_EQ(recipe.reference.units, "mm");
  EXPECT_EQ(recipe.path.units, "inch");
  EXPECT_EQ(recipe.path.options.at("degrees"), "true");
  EXPECT_EQ(recipe.stretch.at("min_scale"), "0.9");
  EXPECT_EQ(recipe.tolerance, 0.0004);
  ASSERT_EQ(recipe.places.size(), 1u);
  EXPECT_EQ(recipe.places[0].position, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(recipe.places[0].radius, 0.004);
  ASSERT_EQ(recipe.programs.size(), 1u);
  EXPECT_EQ(recipe.programs[0].options.at("waypoint_z"), "into_part");
  EXPECT_EQ(recipe.files(),
            (std::vector<std::string>{"recipe.yaml", "program.yaml", "cleaning.yaml",
                                      "reference.stl", "path.csv"}));
}

TEST_F(ARecipeFile, WithAFaultIsRefusedWithItsLineAndKey) {
  const auto expect = [this](const std::string& from, const std::string& to, const std::string& key,
                             int line) {
    const std::string said = refusal(from, to);
    EXPECT_NE(said.find(": " + key + ":"), std::string::npos) << said;
    EXPECT_NE(said.find("(line " + std::to_string(line) + ")"), std::string::npos) << said;
  };
  expect("units: mm", "units: furlong", "reference.units", 5);
  expect("cleaning:", "cleanning:", "cleanning", 4);
  expect("recipe: 1", "recipe: 2", "recipe", 1);
  expect("0.0004", "0", "tolerance", 8);
  expect("0.0004", ".nan", "tolerance", 8);
  expect("0.0004", "4", "tolerance", 8);
  expect("0.0004", "small", "tolerance", 8);
  expect("file: path.csv", "file: ../path.csv", "path.file", 6);
  expect("file: path.csv", "file: /path.csv", "path.file", 6);
  expect("file: part.src", "file: ../../part.src", "robot_programs[0].file", 12);
  expect("[0.1, 0.2, 0.3]", "[0.1, 0.2]", "places[0].position", 10);
  expect("radius: 0.004", "radius: -1", "places[0].radius", 10);
  expect("\"frame <b>\"", "\"\"", "name", 2);
}

TEST_F(ARecipeFile, WithoutAKeyItNeedsIsRefused) {
  for (const char* const line : {"recipe: 1\n", "name: \"frame <b>\"\n", "tolerance: 0.0004\n",
                                 "reference: {file: reference.stl, units: mm}\n"}) {
    const std::string said = refusal(line, "");
    EXPECT_NE(said.find("missing"), std::string::npos) << said;
  }
}

TEST_F(ARecipeFile, WithTwoPlacesOfOneNameIsRefused) {
  const std::string said =
      refusal("robot_programs:", "  - {name: left flank, position: [0, 0, 0]}\nrobot_programs:");
  EXPECT_NE(said.find("places[1].name"), std::string::npos) << said;
}

TEST(ARecipeName, MayHoldSpacesUmlautsAndMarkup) {
  for (const char* name : {"Rahmen groß", "a <b>", "42", "x.y"})
    EXPECT_NO_THROW(check_name(name)) << name;
}

TEST(ARecipeName, ThatLeadsElsewhereIsRefused) {
  using scan_cell_common::InvalidParameter;
  for (const std::string& name :
       {std::string(), std::string("../frame"), std::string(".."), std::string(".hidden"),
        std::string("a/b"), std::string("a\\b"), std::string("a\nb"), std::string(101, 'a')})
    EXPECT_THROW(check_name(name), InvalidParameter) << name;
}

TEST(ARecipeThatIsNotThere, IsRefusedWithThoseThatAre) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "frame");
  scan_cell_common::save_text((folder.path() / "frame" / kRecipeFile).string(), kWhole);
  EXPECT_EQ(find_recipe(folder.path(), "frame"), folder.path() / "frame");
  try {
    find_recipe(folder.path(), "elbow");
    FAIL() << "found";
  } catch (const scan_cell_common::FileError& error) {
    EXPECT_NE(error.cure().find("frame"), std::string::npos) << error.what();
  }
}

TEST(RecipeNames, AreNoneWhereTheFirstRecipeHasYetToMakeTheFolder) {
  const TemporaryFolder folder;
  EXPECT_TRUE(recipe_names_so_far(folder.path() / "recipes").empty());
  EXPECT_THROW(recipe_names(folder.path() / "recipes"), scan_cell_common::FileError);
  scan_cell_common::save_text((folder.path() / "file").string(), "no folder");
  EXPECT_THROW(recipe_names_so_far(folder.path() / "file"), scan_cell_common::FileError);
}

}  // namespace
}  // namespace part_recipes
